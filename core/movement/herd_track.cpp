#include "core/movement/herd_track.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Half the time that what a herd does is averaged over, s. Our choice.
constexpr double smoothing = 60;

/// A herd at rest moves on at most every so many seconds, and takes so long for it. Our choice.
constexpr double rest_stretch = 1200;
constexpr double rest_move = 150;
/// Farthest that it may be from its plan's place meanwhile, m.
constexpr double farthest_rest = 25;

double within_day(double seconds) {
  const double rest = std::fmod(seconds, day_seconds);
  return rest < 0 ? rest + day_seconds : rest;
}

}  // namespace

/// Sums of the shares of the first samples, in whole units: they do not depend on where a stretch begins, so that differences of
/// two are exact.
struct HerdTrack::Sums {
  static constexpr double unit = 1.0 / double(std::int64_t(1) << 32);
  std::int64_t march = 0;
  std::int64_t feeding = 0;
  std::int64_t drinking = 0;
  std::int64_t resting = 0;
  std::int64_t hunting = 0;

  void add(const Sample& sample) {
    const auto units = [](double share) { return std::int64_t(share / unit); };
    march += units(sample.march);
    feeding += units(sample.feeding);
    drinking += units(sample.drinking);
    resting += units(sample.resting);
    hunting += units(sample.hunting);
  }
};

HerdTrack::HerdTrack(const HerdCast& cast, double from, double until, double step)
    : cast_(cast), step_(step), first_(std::int64_t(std::floor(from / step))), last_(std::int64_t(std::ceil(until / step)) + 1) {
  const std::vector<Sample> raw = raw_samples();
  std::vector<Sums> sums(1);
  sums.reserve(raw.size() + 1);
  for (const Sample& sample : raw) {
    sums.push_back(sums.back());
    sums.back().add(sample);
  }
  const auto reach = std::size_t(std::ceil(smoothing / step_));
  const std::size_t averaged = 2 * reach + 1;
  samples_.reserve(std::size_t(last_ - first_ + 1));
  for (std::size_t i = 0; i <= std::size_t(last_ - first_); ++i) {
    const Sums& before = sums[i];
    const Sums& after = sums[i + averaged];
    const auto mean = [&](std::int64_t Sums::*sum) { return double(after.*sum - before.*sum) * (Sums::unit / double(averaged)); };
    samples_.push_back({raw[i + reach].at, raw[i + reach].ahead, mean(&Sums::march), mean(&Sums::feeding), mean(&Sums::drinking),
                        mean(&Sums::resting), mean(&Sums::hunting)});
  }
  first_stretch_ = std::int64_t(std::floor(double(first_) * step_ / rest_stretch)) - 1;
  for (std::int64_t i = first_stretch_; double(i) * rest_stretch <= double(last_) * step_; ++i) {
    stretches_.push_back(
        cast_.world->place_of(cast_.world->state(cast_.plan(), within_day((double(i) + 0.5) * rest_stretch)).at));
  }
}

Place HerdTrack::resting_place(double seconds) const {
  const double stretch = std::floor(seconds / rest_stretch);
  const auto number = std::clamp<std::int64_t>(std::int64_t(stretch) - first_stretch_, 1, std::int64_t(stretches_.size()) - 1);
  const Place before = stretches_[std::size_t(number) - 1];
  const Place now = stretches_[std::size_t(number)];
  return before + (now - before) * smooth_step(0, rest_move, seconds - stretch * rest_stretch);
}

std::vector<HerdTrack::Sample> HerdTrack::raw_samples() const {
  const auto reach = std::int64_t(std::ceil(smoothing / step_));
  std::vector<Sample> samples;
  samples.reserve(std::size_t(last_ - first_ + 1 + 2 * reach));
  for (std::int64_t i = first_ - reach; i <= last_ + reach; ++i) {
    const HerdState state = cast_.world->state(cast_.plan(), within_day(double(i) * step_));
    Sample sample;
    sample.at = cast_.world->place_of(state.at);
    sample.ahead = {std::sin(double(state.heading)), std::cos(double(state.heading))};
    sample.march = std::clamp((double(state.speed) - 0.12) / 0.4, 0.0, 1.0);
    sample.feeding = state.activity == HerdActivity::feeding;
    sample.drinking = state.activity == HerdActivity::drinking;
    // Between its stops a herd walks; one that has nowhere to go rests.
    sample.resting = state.activity == HerdActivity::resting || (state.activity == HerdActivity::walking && state.speed < 0.05F);
    sample.hunting = state.activity == HerdActivity::hunting;
    samples.push_back(sample);
  }
  return samples;
}

void HerdTrack::set_stops(HerdMoment& moment, double seconds) const {
  const std::vector<PlanStop>& stops = cast_.plan().stops;
  if (stops.size() < 2) return;
  // Stops may pass midnight: times count from the first arrival.
  const double first = double(stops.front().arrive) * 3600;
  const double now = first + within_day(seconds - first);
  std::size_t last = 0;
  while (last + 1 < stops.size() && double(stops[last + 1].arrive) * 3600 <= now) ++last;
  moment.stop = last;
  moment.next_stop = (last + 1) % stops.size();
  const double leave = double(stops[last].leave) * 3600;
  const double arrive = last + 1 < stops.size() ? double(stops[last + 1].arrive) * 3600 : first + day_seconds;
  moment.between = now <= leave ? 0 : smooth_step(leave, std::max(arrive, leave + 1), now);
}

HerdMoment HerdTrack::at(double seconds) const {
  const double position = seconds / step_ - double(first_);
  const double clamped = std::clamp(position, 0.0, double(samples_.size() - 1));
  const std::size_t below = std::min(std::size_t(clamped), samples_.size() - 2);
  const double t = clamped - double(below);
  const Sample& a = samples_[below];
  const Sample& b = samples_[below + 1];
  const auto mixed = [t](double from, double until) { return from + (until - from) * t; };
  HerdMoment moment;
  moment.at = a.at + (b.at - a.at) * t;
  moment.ahead = unit_of(a.ahead + (b.ahead - a.ahead) * t, a.ahead);
  moment.march = mixed(a.march, b.march);
  moment.feeding = mixed(a.feeding, b.feeding);
  moment.drinking = mixed(a.drinking, b.drinking);
  moment.resting = mixed(a.resting, b.resting);
  moment.hunting = mixed(a.hunting, b.hunting);
  // Never far from the plan's place, where the herd comes to its rest or leaves it.
  const Place behind = resting_place(seconds) - moment.at;
  moment.rests_at = moment.at + behind * std::min(1.0, farthest_rest / std::max(length(behind), 1e-9));
  set_stops(moment, seconds);
  return moment;
}

}  // namespace biotope
