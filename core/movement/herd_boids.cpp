#include "core/movement/herd_boids.hpp"

#include <algorithm>
#include <numeric>

namespace biotope {

namespace {

constexpr BoidWeights weights;
/// Seconds of a step while anybody runs, while the herd walks or grazes, and while it rests.
constexpr double step_of(HerdPace pace) { return pace == HerdPace::running ? 0.5 : pace == HerdPace::walking ? 1 : 2; }
/// Seconds within which a member wants to be where its guide is, and how near is near enough, in body lengths.
constexpr double arrival_seconds = 2.5;
constexpr double near_enough = 0.22;
/// Within so many body lengths members keep apart, and see each other.
constexpr double separation_reach = 1.15;
constexpr double sight_reach = 4;
/// Fastest turn, rad/s, while slow; and steepest speed-up for one that caught up, of the walk.
constexpr double fastest_turn = 1.3;
constexpr double catching_up = 1.9;

Place velocity_of(const BoidState& state) { return Place{double(state.east), double(state.north)} * double(state.speed); }

Place limited(Place wish, double most) {
  const double size = length(wish);
  return size > most ? wish * (most / size) : wish;
}

std::vector<const HerdCast*> pointers(const std::vector<std::shared_ptr<const HerdCast>>& casts) {
  std::vector<const HerdCast*> list;
  for (const auto& cast : casts) list.push_back(cast.get());
  return list;
}

/// Share of the flat speed that a slope allows: the species' hiking function.
double slope_share(const HerdCast& cast, Place place, Place direction) {
  const double slope = cast.world->slope_along(place, direction);
  const double k = double(cast.world->traits(cast.plan()).slope_sensitivity);
  return std::clamp(std::exp(-k * (std::abs(slope + 0.05) - 0.05)), 0.15, 1.2);
}

/// Numbers ascending in x; nearly sorted already.
void sort_by_x(const std::vector<BoidState>& states, std::vector<std::uint32_t>& order) {
  if (order.size() != states.size()) {
    order.resize(states.size());
    std::iota(order.begin(), order.end(), 0U);
  }
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return states[a].x < states[b].x || (states[a].x == states[b].x && a < b);
  };
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::uint32_t moved = order[i];
    std::size_t k = i;
    for (; k > 0 && before(moved, order[k - 1]); --k) order[k] = order[k - 1];
    order[k] = moved;
  }
}

/// Turns a unit vector toward another by at most `most` radians.
Place turned_toward(Place from, Place to, double most) {
  const double cosine = std::clamp(dot(from, to), -1.0, 1.0);
  const double angle = std::acos(cosine);
  if (angle <= most) return to;
  // About face always goes to the left, so that runs from different checkpoints turn alike.
  const double side = cosine < -0.75 || from.x * to.y - from.y * to.x >= 0 ? 1 : -1;
  const double c = std::cos(most);
  const double s = side * std::sin(most);
  return {from.x * c - from.y * s, from.x * s + from.y * c};
}

}  // namespace

double stride_length(double hip, double speed) {
  const double froude = speed * speed / (9.81 * hip);
  return std::max(0.05 * hip, 2.4 * hip * std::pow(froude, 0.34));
}

void push_apart(const HerdCast& cast, Place origin, std::vector<BoidState>& states, int times) {
  std::vector<std::uint32_t> order;
  const auto nearest = float(closest_members * cast.body_length);
  std::vector<std::pair<float, float>> push(states.size());
  for (int time = 0; time < times; ++time) {
    sort_by_x(states, order);
    std::fill(push.begin(), push.end(), std::pair{0.0F, 0.0F});
    bool any = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t k = i + 1; k < order.size() && states[order[k]].x - states[order[i]].x < nearest; ++k) {
        const std::uint32_t a = std::min(order[i], order[k]);
        const std::uint32_t b = std::max(order[i], order[k]);
        float dx = states[b].x - states[a].x;
        float dy = states[b].y - states[a].y;
        float distance = std::sqrt(dx * dx + dy * dy);
        if (distance >= nearest) continue;
        any = true;
        if (distance < 1e-4F) {
          // One upon the other: apart by their numbers.
          dx = std::cos(float(a) * 2.4F);
          dy = std::sin(float(a) * 2.4F);
          distance = 1;
        }
        const float share = 0.52F * (nearest - std::min(distance, nearest)) / distance;
        push[a].first -= dx * share;
        push[a].second -= dy * share;
        push[b].first += dx * share;
        push[b].second += dy * share;
      }
    }
    if (!any) return;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (push[i].first == 0 && push[i].second == 0) continue;
      const Place to = origin + Place{double(states[i].x + push[i].first), double(states[i].y + push[i].second)};
      if (!cast.passable(to)) continue;
      states[i].x += push[i].first;
      states[i].y += push[i].second;
    }
  }
}

BoidRun::BoidRun(std::shared_ptr<const HerdCast> cast, std::vector<std::shared_ptr<const HerdCast>> predators,
                 std::vector<std::shared_ptr<const HerdCast>> followed, int checkpoint)
    : cast_(std::move(cast)),
      predators_(std::move(predators)),
      followed_(std::move(followed)),
      start_(checkpoint * checkpoint_seconds),
      guides_(*cast_, pointers(predators_), pointers(followed_), start_, start_ + run_seconds, 1) {
  step_ = step_of(guides_.pace(start_, start_ + run_seconds));
  guides_.at(start_, guides_now_);
  origin_ = guides_.moment(start_).at;
  std::vector<BoidState> states;
  // A moment before, for the velocities that members begin with.
  guides_.at(start_ + step_, guides_next_);
  for (std::size_t i = 0; i < guides_now_.size(); ++i) {
    const HerdGuide& guide = guides_now_[i];
    const Place move = (guides_next_[i].at - guide.at) * (1 / step_);
    const double speed = length(move);
    const Place heading = speed > 0.25 ? move * (1 / speed) : guide.facing;
    const Place at = guide.at - origin_;
    states.push_back({float(at.x), float(at.y), float(heading.x), float(heading.y), float(std::atan2(heading.x, heading.y)),
                      float(std::min(speed, cast_->gallop_speed)), 0});
  }
  push_apart(*cast_, origin_, states, 6);
  steps_.push_back(std::move(states));
}

std::vector<int> BoidRun::predators() const {
  std::vector<int> plans;
  for (const auto& predator : predators_) plans.push_back(predator->plan_number);
  return plans;
}

void BoidRun::neighbours(const std::vector<BoidState>& states) {
  around_.assign(states.size(), {});
  sort_by_x(states, order_);
  const double sight = sight_reach * cast_->body_length;
  const double apart = separation_reach * cast_->body_length;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    for (std::size_t k = i + 1; k < order_.size(); ++k) {
      const std::uint32_t a = std::min(order_[i], order_[k]);
      const std::uint32_t b = std::max(order_[i], order_[k]);
      if (double(states[order_[k]].x - states[order_[i]].x) > sight) break;
      const Place between{double(states[b].x - states[a].x), double(states[b].y - states[a].y)};
      const double distance2 = dot(between, between);
      if (distance2 > sight * sight) continue;
      const auto meet = [&](Around& around, const BoidState& other) {
        around.velocity = around.velocity + velocity_of(other);
        around.centre = around.centre + Place{double(other.x), double(other.y)};
        ++around.count;
      };
      meet(around_[a], states[b]);
      meet(around_[b], states[a]);
      if (distance2 >= apart * apart || distance2 < 1e-8) continue;
      const double distance = std::sqrt(distance2);
      const Place push = between * ((1 - distance / apart) / distance);
      around_[a].push = around_[a].push - push;
      around_[b].push = around_[b].push + push;
    }
  }
}

/// What one member sees of itself before a step.
struct BoidRun::Sight {
  const BoidState& state;
  const HerdGuide& guide;
  Place at;  ///< relative to the origin
  Place world_at;
  Place heading;
  Place velocity;
  Place gap;  ///< to where the guide will be
  Place guide_velocity;
  double slack = 0;    ///< m within which the member is where it should be
  double fastest = 0;  ///< m/s
};

BoidRun::Sight BoidRun::sight(std::size_t member, const BoidState& state) const {
  const HerdGuide& guide = guides_now_[member];
  Sight sight{state, guide, {double(state.x), double(state.y)}, {}, {double(state.east), double(state.north)}, velocity_of(state),
              {},    {}};
  sight.world_at = origin_ + sight.at;
  const double trot = cast_->walk_speed * catching_up;
  sight.fastest = (trot + (cast_->gallop_speed - trot) * guide.haste) * slope_share(*cast_, sight.world_at, sight.heading);
  sight.gap = guides_next_[member].at - sight.world_at;
  sight.guide_velocity = (guides_next_[member].at - guide.at) * (1 / step_);
  sight.slack = near_enough * cast_->body_length * (1 - guide.march);
  return sight;
}

/// The sum of what the rules wish, m/s2.
Place BoidRun::steering(const Sight& sight, const Around& around) const {
  const HerdGuide& guide = sight.guide;
  const double moves = std::max(guide.march, guide.haste);
  const double far = length(sight.gap);
  // Path: toward the guide, and with it. No wish is overshot within a step, however long it is.
  Place wish = sight.guide_velocity;
  if (far > sight.slack) wish = wish + sight.gap * ((far - sight.slack) / far / arrival_seconds);
  wish = limited(wish, std::min(sight.fastest, length(sight.guide_velocity) + 0.7 * far / step_));
  Place force = (wish - sight.velocity) * std::min(weights.path, 0.9 / step_);
  if (around.count > 0) {
    const double share = 1.0 / around.count;
    force = force + (around.velocity * share - sight.velocity) * (std::min(weights.alignment, 0.4 / step_) * 0.5 * moves);
    const Place middle = around.centre * share - sight.at;
    force = force + limited(middle * (1 / (sight_reach * cast_->body_length)), 1) * (weights.cohesion * 0.25 * guide.march);
    // Who stands lets others come nearer than who walks.
    const double crowded = std::max(0.0, length(around.push) - (1 - moves) * 0.3);
    force = force + unit_of(around.push) * (crowded * weights.separation * (0.4 + 0.6 * cast_->walk_speed * moves));
  }
  force = force + avoidance(sight) * weights.obstacle;
  return limited(force, most_force + (most_flight_force - most_force) * guide.haste);
}

/// Away from what cannot be walked on two seconds ahead: to the side that is open, or on which the guide is.
Place BoidRun::avoidance(const Sight& sight) const {
  const double speed = double(sight.state.speed);
  const Place ahead = sight.world_at + sight.velocity * 2.0 + sight.heading * (0.5 * cast_->body_length);
  if (speed <= 0.05 || cast_->passable(ahead)) return {};
  const Place left{-sight.heading.y, sight.heading.x};
  const double reach = std::max(2.0, 2.0 * speed);
  const bool open_left = cast_->passable(sight.world_at + (sight.heading * 0.6 + left * 0.8) * reach);
  const bool open_right = cast_->passable(sight.world_at + (sight.heading * 0.6 - left * 0.8) * reach);
  const double toward_guide = dot(sight.gap, left) >= 0 ? 1 : -1;
  const double side = open_left == open_right ? toward_guide : open_left ? 1 : -1;
  return left * (side * std::max(0.6, speed)) - sight.heading * (0.5 * speed);
}

/// Nobody sidles: animals turn, and walk where they look.
BoidState BoidRun::moved(const Sight& sight, const Around& around, double size) const {
  const HerdGuide& guide = sight.guide;
  const Place heading = sight.heading;
  const Place wanted = sight.velocity + steering(sight, around) * step_;
  const double wanted_speed = length(wanted);
  const bool called = length(sight.gap) > sight.slack || length(sight.guide_velocity) > 0.05 || length(around.push) > 0.45;
  Place facing = heading;
  double speed = 0;
  if (wanted_speed > 0.14 && called) {
    const Place direction = wanted * (1 / wanted_speed);
    facing = turned_toward(heading, direction, fastest_turn * (1 + 1.2 * guide.haste) * step_);
    speed = std::min(sight.fastest, wanted_speed * std::max(0.0, dot(facing, direction)));
    if (dot(facing, direction) < 0.3) speed = std::min(speed, 0.25 * cast_->walk_speed);
  } else if (dot(heading, guide.facing) < 0.8) {
    facing = turned_toward(heading, guide.facing, 0.45 * step_);
  }
  const double before = double(sight.state.speed);
  const double change = (most_force + (most_flight_force - most_force) * guide.haste) * step_;
  speed = std::clamp(speed, before - change, before + change);
  if (speed < 0.03) speed = 0;
  Place move = facing * (0.5 * (speed + before) * step_);
  if (!cast_->passable(sight.world_at + move)) {
    // Along the edge, or not at all.
    const Place east{move.x, 0};
    const Place north{0, move.y};
    move = cast_->passable(sight.world_at + east) ? east : cast_->passable(sight.world_at + north) ? north : Place{};
    speed = std::min(speed, length(move) / step_);
  }
  const double walked = length(move);
  const double stride = stride_length(hip_height(cast_->shoulder * size), std::max(walked / step_, 0.05));
  const double turned = std::atan2(heading.y * facing.x - heading.x * facing.y, dot(heading, facing));
  return {float(sight.at.x + move.x),
          float(sight.at.y + move.y),
          float(facing.x),
          float(facing.y),
          sight.state.angle + float(turned),
          float(speed),
          float(double(sight.state.cycles) + walked / stride)};
}

void BoidRun::advance() {
  const std::vector<BoidState>& before = steps_.back();
  const double now = start_ + step_ * double(steps_.size() - 1);
  if (steps_.size() > 1) std::swap(guides_now_, guides_next_);
  guides_.at(now + step_, guides_next_);
  neighbours(before);
  std::vector<BoidState> after;
  after.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    after.push_back(moved(sight(i, before[i]), around_[i], double(cast_->members[i].size)));
  }
  push_apart(*cast_, origin_, after, 2);
  steps_.push_back(std::move(after));
}

void BoidRun::at(double since, std::vector<BoidState>& states) {
  const double position = std::clamp(since, 0.0, run_seconds) / step_;
  const auto below = std::size_t(position);
  const double share = position - double(below);
  while (steps_.size() < below + 1 + (share > 0 ? 1 : 0)) advance();
  states = steps_[below];
  if (share <= 0) return;
  const std::vector<BoidState>& next = steps_[below + 1];
  const auto t = float(share);
  const auto span = float(step_);
  // A cubic through both places with both velocities.
  const float h00 = (1 + 2 * t) * (1 - t) * (1 - t);
  const float h10 = t * (1 - t) * (1 - t) * span;
  const float h01 = t * t * (3 - 2 * t);
  const float h11 = t * t * (t - 1) * span;
  for (std::size_t i = 0; i < states.size(); ++i) {
    BoidState& a = states[i];
    const BoidState& b = next[i];
    const float moved = std::hypot(b.x - a.x, b.y - a.y);
    // One that was pushed stands there; it must not swing over.
    const bool smooth = moved > 0.3F * span * std::max(a.speed, b.speed);
    if (smooth) {
      a.x = h00 * a.x + h10 * a.speed * a.east + h01 * b.x + h11 * b.speed * b.east;
      a.y = h00 * a.y + h10 * a.speed * a.north + h01 * b.y + h11 * b.speed * b.north;
    } else {
      a.x += (b.x - a.x) * t;
      a.y += (b.y - a.y) * t;
    }
    a.angle += (b.angle - a.angle) * t;
    a.speed += (b.speed - a.speed) * t;
    a.cycles += (b.cycles - a.cycles) * t;
  }
}

}  // namespace biotope
