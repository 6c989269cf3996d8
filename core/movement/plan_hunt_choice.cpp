#include "core/movement/plan_hunt_choice.hpp"

#include <algorithm>

#include "core/base/random.hpp"
#include "core/movement/plan_track.hpp"

namespace biotope {
namespace {

/// Hours at a herd. Who hunts alone stalks: 90 to 150 minutes, as long as herds stay at a resource (2021 authors). Packs course:
/// they go to many herds and soon know whether there is something to be had (our choice).
constexpr double shortest_stalk = 1.5;
constexpr double longest_stalk = 2.5;
constexpr double shortest_course = 0.75;
constexpr double longest_course = 1.25;
/// Nobody sets out for a herd where less time than this would be left, h. Our choice.
constexpr double shortest_visit = 0.4;
/// Herds within so many hours are equally near (eq. 2 divides by the travelling time). Our choice.
constexpr double near_by = 0.05;
/// Who hunts alone goes to one of so many herds that it reaches first; packs range wide, to any herd of their region. Our choice.
constexpr std::uint32_t choices_alone = 6;
/// More steps than this are no day: those it chose came to nothing.
constexpr std::uint64_t most_steps = 64;
/// A resting place is out of sight of the herd near which it lies, so far away, m. Our choice.
constexpr double nearest_rest = 500;
constexpr double farthest_rest = 1200;
/// The way home is longer than the straight line, as far as is known before it is searched. Our choice.
constexpr double detour = 1.4;

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

HuntChoice::HuntChoice(HuntGround& ground)
    : ground_(ground),
      key_(ground.input.keys[std::size_t(ground.pack.herd)]),
      prey_(ground.pack.prey),
      visited_(prey_.size(), 0),
      spans_(active_hours(ground.animal.activity)),
      speed_(double(ground.animal.speed)),
      alone_(ground.animal.herd_max <= 1),
      drinks_(ground.animal.water_visits) {
  for (const DailyPlan::Span& span : spans_) awake_ += double(span.until) - double(span.from);
  hour_ = double(spans_.front().from);
  rest_ = at_ = resting_place();
  done_ = ground_.vertex_at(rest_) < 0;
  find_banks();
}

double HuntChoice::unit(std::uint64_t what) const { return random_unit({key_, steps_, what}); }

void HuntChoice::find_banks() {
  const LevelTravel& travel = *ground_.input.movement.travel;
  const auto species = std::size_t(species_index_of(ground_.input.level, ground_.herd));
  for (const auto& [node, probability] : travel.presence[species][std::size_t(ground_.herd.region)]) {
    const int vertex = travel.vertex_of_node[std::size_t(ground_.number)][std::size_t(node)];
    if (ground_.input.level.graph->nodes[std::size_t(node)].kind == NodeKind::bank && vertex >= 0)
      banks_.push_back({node, vertex, 0});
  }
}

PathPoint HuntChoice::resting_place() {
  const int drawn = draw([&](std::size_t i) { return prey_[i].probability; }, random_unit({key_, 40}));
  const PathPoint home = prey_[std::size_t(std::max(drawn, 0))].herd.day->way.front().at;
  const Grid<float>& height = ground_.ground.height();
  constexpr std::uint64_t tries = 64;
  for (std::uint64_t i = 0; i < tries; ++i) {
    const double angle = 2 * 3.14159265358979 * random_unit({key_, i, 44});
    const double cells =
        (nearest_rest + (farthest_rest - nearest_rest) * random_unit({key_, i, 45})) / ground_.ground.cell_size();
    const PathPoint place{std::round(home.x + float(cells * std::cos(angle))),
                          std::round(home.y + float(cells * std::sin(angle)))};
    if (height.contains(int(place.x), int(place.y)) && ground_.vertex_at(place) >= 0 && !ground_.wet(place)) return place;
  }
  return home;
}

/// A prey herd drawn by weight; -1 when all are zero.
template <class Weight>
int HuntChoice::draw(const Weight& weight, double unit) {
  weights_.clear();
  double total = 0;
  for (std::size_t i = 0; i < prey_.size(); ++i) {
    weights_.push_back(weight(i));
    total += weights_.back();
  }
  if (total <= 0) return -1;
  double left = unit * total;
  int last = -1;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    if (weights_[i] <= 0) continue;
    last = int(i);
    if ((left -= weights_[i]) < 0) break;
  }
  return last;
}

/// Whether a herd is of the pack's own share.
bool HuntChoice::is_own(std::size_t i) const { return (prey_[i].herd.plan + ground_.pack.number) % ground_.pack.neighbours == 0; }

/// Where the herds are that it may visit: of its own those that it visited least today, or any other of these, or of all, or the
/// last one again.
void HuntChoice::find_herds() {
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < prey_.size(); ++i) {
    if (is_own(i)) least = std::min(least, visited_[i]);
  }
  const auto find = [&](const auto& allowed) {
    bool any = false;
    herd_vertex_.assign(prey_.size(), -1);
    for (std::size_t i = 0; i < prey_.size(); ++i) {
      if (!allowed(i)) continue;
      herd_vertex_[i] = ground_.vertex_at(place_on_way(*prey_[i].herd.day, hour_));
      any = any || herd_vertex_[i] >= 0;
    }
    return any;
  };
  if (find([&](std::size_t i) { return int(i) != last_ && is_own(i) && visited_[i] == least; })) return;
  if (find([&](std::size_t i) { return int(i) != last_ && is_own(i); })) return;
  if (find([&](std::size_t i) { return int(i) != last_; })) return;
  find([&](std::size_t i) { return int(i) == last_; });
}

void HuntChoice::look(double hour, PathPoint at) {
  hour_ = std::max(hour, double(spans_[span_].from));
  at_ = at;
  thirsty_ = drunk_ < drinks_ && (over_ || awake_so_far() >= awake_ * (drunk_ + 0.5) / drinks_);
  std::vector<std::uint16_t> goals(ground_.graph.vertices.size(), 0);
  std::uint32_t wanted = 0;
  const auto want = [&](int vertex) {
    if (vertex < 0) return;
    ++goals[std::size_t(vertex)];
    ++wanted;
  };
  if (thirsty_) {
    for (const Bank& bank : banks_) want(bank.vertex);
  } else {
    find_herds();
    for (const int vertex : herd_vertex_) want(vertex);
  }
  ground_.searched_from = ground_.vertex_at(at_);
  const std::uint32_t choices = thirsty_ ? 1 : alone_ ? choices_alone : wanted;
  const bool known = ground_.searched_from >= 0 && wanted > 0;
  if (known) ground_.search.run(std::uint32_t(ground_.searched_from), goals, std::min(wanted, choices));
  const auto hours = [&](int vertex) {
    return vertex < 0 || !known ? never : double(ground_.search.cost(std::uint32_t(vertex))) / speed_ / 3600;
  };
  if (!known) ground_.searched_from = -1;
  for (Bank& bank : banks_) bank.hours = thirsty_ ? hours(bank.vertex) : never;
  walk_.clear();
  if (thirsty_) return;
  for (const int vertex : herd_vertex_) walk_.push_back(hours(vertex));
}

std::optional<HuntStep> HuntChoice::choose() {
  std::optional<HuntStep> step;
  if (thirsty_) {
    step = drink_nearby();
    if (!step) drinks_ = drunk_;
  } else if (!over_) {
    step = visit();
    if (!step && span_ + 1 < spans_.size()) {
      before_ += double(spans_[span_].until) - double(spans_[span_].from);
      ++span_;
    } else if (!step) {
      over_ = true;
    }
  }
  done_ = (over_ && drunk_ >= drinks_) || steps_ >= most_steps;
  steps_ += step.has_value();
  return step;
}

/// The last hours end in time to walk home from a place.
double HuntChoice::end_at(PathPoint place) const {
  const double until = double(spans_[span_].until);
  if (span_ + 1 < spans_.size()) return until;
  const double cells = std::hypot(double(place.x - rest_.x), double(place.y - rest_.y));
  return until - detour * cells * ground_.ground.cell_size() / speed_ / 3600;
}

/// P_s(v' | v) of a herd where it is now; 0 when there is no time left for it or no way to it.
double HuntChoice::attraction(std::size_t i) const {
  if (walk_[i] == never || hour_ + walk_[i] + shortest_visit > end_at(place_on_way(*prey_[i].herd.day, hour_))) return 0;
  return prey_[i].probability / std::max(walk_[i], near_by);
}

/// To a herd, or to the last one again where there is no other.
std::optional<HuntStep> HuntChoice::visit() {
  const int drawn = draw([&](std::size_t i) { return attraction(i); }, unit(41));
  if (drawn < 0) return std::nullopt;
  const FollowedHerd& herd = prey_[std::size_t(drawn)].herd;
  const double arrive = hour_ + walk_[std::size_t(drawn)];
  const double low = alone_ ? shortest_stalk : shortest_course;
  const double high = alone_ ? longest_stalk : longest_course;
  double leave = arrive + low + (high - low) * unit(42);
  // What would be left of the hours is too short for another.
  const double end = end_at(place_on_way(*herd.day, leave));
  if (leave + shortest_visit > end) leave = std::max(arrive + shortest_visit / 2, end);
  ++visited_[std::size_t(drawn)];
  last_ = drawn;
  return HuntStep{drawn, -1, span_, arrive, leave};
}

/// To the nearest bank.
std::optional<HuntStep> HuntChoice::drink_nearby() {
  const auto nearest =
      std::min_element(banks_.begin(), banks_.end(), [](const Bank& a, const Bank& b) { return a.hours < b.hours; });
  if (nearest == banks_.end() || nearest->hours == never) return std::nullopt;
  ++drunk_;
  const double arrive = hour_ + nearest->hours;
  return HuntStep{-1, nearest->node, span_, arrive, arrive + drink};
}

}  // namespace biotope
