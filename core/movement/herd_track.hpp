#pragma once

#include <cstdint>
#include <vector>

#include "core/movement/herd_cast.hpp"

namespace biotope {

/// What a herd as a whole does at a moment, smooth in time: everything is averaged over two minutes, so that animals gather and
/// scatter, lie down and get up at a walk.
struct HerdMoment {
  Place at;            ///< the plan's place
  Place rests_at;      ///< the same, but moved on only now and then: who lies does not drift along with a herd that grazes on
  Place ahead{0, 1};   ///< direction of the walk, unit vector; of the last while it stands
  double march = 0;    ///< 0 standing about .. 1 walking in file
  double feeding = 0;  ///< shares of what it does while it stands
  double drinking = 0;
  double resting = 0;
  double hunting = 0;
  /// Stop it is at or comes from, the one it goes to, and how far it is between, 0..1.
  std::size_t stop = 0;
  std::size_t next_stop = 0;
  double between = 0;
};

/// A herd's moments over a stretch of its day, sampled once and then cheap to look up. Times are seconds since midnight and may
/// lie outside of the day (then of the days beside it, which are the same).
class HerdTrack {
 public:
  /// `step`: seconds from one sample to the next; finer than 20 s or so nobody sees the difference.
  HerdTrack(const HerdCast& cast, double from, double until, double step);

  [[nodiscard]] HerdMoment at(double seconds) const;
  [[nodiscard]] std::size_t bytes() const { return samples_.capacity() * sizeof(Sample) + stretches_.capacity() * sizeof(Place); }

 private:
  struct Sample {
    Place at;
    Place ahead;
    double march = 0;
    double feeding = 0;
    double drinking = 0;
    double resting = 0;
    double hunting = 0;
  };
  struct Sums;
  [[nodiscard]] std::vector<Sample> raw_samples() const;
  [[nodiscard]] Place resting_place(double seconds) const;
  void set_stops(HerdMoment& moment, double seconds) const;

  const HerdCast& cast_;
  double step_;
  std::int64_t first_;
  std::int64_t last_;
  std::vector<Sample> samples_;
  /// The plan's place in the middle of each stretch of rest, from `first_stretch_` on.
  std::int64_t first_stretch_ = 0;
  std::vector<Place> stretches_;
};

}  // namespace biotope
