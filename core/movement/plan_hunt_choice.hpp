#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/movement/plan_hunt.hpp"

namespace biotope {

/// Chooses the steps of one pack's day.
class HuntChoice {
 public:
  explicit HuntChoice(HuntGround& ground);

  /// Dry ground some way off one of its herds.
  [[nodiscard]] PathPoint rest() const { return rest_; }
  [[nodiscard]] bool done() const { return done_; }
  /// Finds out how far it is to where it may go now.
  void look(double hour, PathPoint at);
  /// The next step; nothing when its hours or its day end.
  [[nodiscard]] std::optional<HuntStep> choose();

 private:
  struct Bank {
    int node = 0;
    int vertex = -1;
    double hours = 0;
  };

  [[nodiscard]] double unit(std::uint64_t what) const;
  [[nodiscard]] double awake_so_far() const { return before_ + hour_ - double(spans_[span_].from); }
  void find_banks();
  [[nodiscard]] PathPoint resting_place();
  template <class Weight>
  [[nodiscard]] int draw(const Weight& weight, double unit);
  [[nodiscard]] bool is_own(std::size_t i) const;
  void find_herds();
  [[nodiscard]] double end_at(PathPoint place) const;
  [[nodiscard]] double attraction(std::size_t i) const;
  [[nodiscard]] std::optional<HuntStep> visit();
  [[nodiscard]] std::optional<HuntStep> drink_nearby();

  HuntGround& ground_;
  std::uint64_t key_;
  std::span<const PreyHerd> prey_;
  std::vector<int> visited_;
  std::vector<Bank> banks_;
  std::vector<double> weights_;
  std::vector<DailyPlan::Span> spans_;
  std::vector<int> herd_vertex_;
  /// Hours to each herd, as looked for.
  std::vector<double> walk_;
  double speed_ = 1;
  double awake_ = 0;
  double before_ = 0;
  bool alone_ = false;
  bool thirsty_ = false;
  bool over_ = false;
  bool done_ = false;
  int drinks_ = 0;
  int drunk_ = 0;
  int last_ = -1;
  std::uint64_t steps_ = 0;
  std::size_t span_ = 0;
  double hour_ = 0;
  PathPoint at_;
  PathPoint rest_;
};

}  // namespace biotope
