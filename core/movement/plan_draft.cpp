#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/random.hpp"
#include "core/movement/plan_parts.hpp"
#include "core/movement/travel_search.hpp"

namespace biotope {
namespace {

/// Ground an animal of a herd takes for itself at a resource, m2. Our choice.
constexpr double ground_per_animal = 100;
/// Banks are lines: an animal that drinks takes less. Our choice.
constexpr double bank_per_animal = 10;
/// No walk of a plan is longer, h. Our choice.
constexpr float longest_leg = 2;
/// For food nobody walks longer than so in a day, home again included, but rather stays longer where it is, h; and where water is
/// farther than this it drinks but once. Our choices.
constexpr float longest_walk = 1.25F;
constexpr float far_water = 0.75F;
/// Detour of a real way against the straight line, to guess the way home. Our choice.
constexpr double detour = 1.4;
constexpr std::size_t most_stops = 24;
/// How long a herd stays at a waypoint, h. Our choice.
constexpr double shortest_call = 0.25;
constexpr double longest_call = 0.5;

/// Drafts the days of one level.
class Drafter {
 public:
  explicit Drafter(const PlanInput& input) : input_(input), taken_(input.level.graph->nodes.size()) {}

  DayDraft draft(int herd_number) {
    const Herd& herd = input_.level.herds[std::size_t(herd_number)];
    day_ = {species_index_of(input_.level, herd), herd_number, {}};
    animal_ = &input_.web.species[std::size_t(herd.species)].animal();
    herd_ = herd;
    presence_ = input_.movement.travel->presence[std::size_t(day_.species_index)][std::size_t(herd.region)];
    home_ = choose_home();
    if (home_ < 0) return day_;
    visits_ = has_banks() ? animal_->water_visits : 0;
    drunk_ = 0;
    walked_ = 0;
    spans_ = active_hours(animal_->activity);
    span_ = 0;
    hour_ = spans_.front().from;
    stay(home_);
    while (day_.stays.size() < most_stops && go_on()) {
    }
    while (drunk_ < visits_ && visit(true)) {
    }
    add_waypoints();
    return day_;
  }

 private:
  [[nodiscard]] const ResourceNode& node(int number) const { return input_.level.graph->nodes[std::size_t(number)]; }
  [[nodiscard]] bool is_bank(int number) const { return node(number).kind == NodeKind::bank; }
  [[nodiscard]] bool is_waypoint(int number) const { return node(number).kind == NodeKind::waypoint; }
  [[nodiscard]] int here() const { return day_.stays.back().node; }
  [[nodiscard]] double chance(std::uint64_t what) const {
    return random_unit({input_.keys[std::size_t(day_.herd)], what, day_.stays.size()});
  }
  [[nodiscard]] bool has_banks() const {
    return std::any_of(presence_.begin(), presence_.end(), [&](const auto& p) { return is_bank(p.node); });
  }

  /// Whether the herd still finds room at a node at an hour.
  [[nodiscard]] bool room(int number, float hour) const {
    const auto& taken = taken_[std::size_t(number)];
    const double each = is_bank(number) ? bank_per_animal : ground_per_animal;
    return (taken[slot(hour)] + herd_.size) * each <= node(number).area || taken[slot(hour)] == 0;
  }
  static std::size_t slot(float hour) { return std::size_t(hour) % 24; }

  /// An index drawn by weight; -1 when all are zero.
  template <class Weight>
  [[nodiscard]] int draw(std::size_t count, double unit, const Weight& weight) const {
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) total += weight(i);
    if (total <= 0) return -1;
    double left = unit * total;
    int last = -1;
    for (std::size_t i = 0; i < count; ++i) {
      const double w = weight(i);
      if (w <= 0) continue;
      last = int(i);
      if ((left -= w) < 0) break;
    }
    return last;
  }

  /// Where the herd rests at night: food by P_s(v), with room for it.
  [[nodiscard]] int choose_home() {
    for (const bool crowded : {false, true}) {
      const int drawn = draw(presence_.size(), chance(1), [&](std::size_t i) {
        const auto& [number, probability] = presence_[i];
        if (is_bank(number) || is_waypoint(number) || !stands(number)) return 0.0;
        return crowded || room(number, active_hours(animal_->activity).back().until) ? double(probability) : 0.0;
      });
      if (drawn >= 0) return presence_[std::size_t(drawn)].node;
    }
    return -1;
  }
  [[nodiscard]] bool stands(int number) const {
    const LevelTravel& travel = *input_.movement.travel;
    return travel.vertex_of_node[std::size_t(travel.graph_of_species[std::size_t(day_.species_index)])][std::size_t(number)] >= 0;
  }

  [[nodiscard]] float hours_home(int number) const {
    return float(metres_between(number, home_) * detour / double(animal_->speed) / 3600);
  }

  /// 90 to 150 minutes (2021 authors), longer where more is to be had; drinking takes 25 to 45 minutes (our choice).
  [[nodiscard]] float stay_hours(int number) const {
    const double unit = chance(2);
    if (is_bank(number)) return float((25 + 20 * unit) / 60);
    double probability = 0;
    for (const auto& p : presence_) {
      if (p.node == number) probability = double(p.probability);
    }
    const double richness = std::min(1.0, 0.5 * probability * double(presence_.size()));
    return float((90 + 60 * (0.5 * unit + 0.5 * richness)) / 60);
  }

  void stay(int number) {
    const float hours = stay_hours(number);
    day_.stays.push_back({number, hours, 0});
    for (int h = 0; h <= int(hours); ++h) taken_[std::size_t(number)][slot(hour_ + float(h))] += herd_.size;
    hour_ += hours;
    if (is_bank(number)) ++drunk_;
  }

  void go(int number, float walk) {
    hour_ += walk;
    walked_ += walk;
    stay(number);
  }

  /// Feeds on where it is.
  void stay_longer() {
    const float hours = stay_hours(here()) / 2;
    for (int h = 0; h <= int(hours); ++h) taken_[std::size_t(here())][slot(hour_ + float(h))] += herd_.size;
    day_.stays.back().hours += hours;
    hour_ += hours;
  }

  /// Walks to a bank or to food, drawn by P_s(v' | v) among nodes with room; false when there is none.
  bool visit(bool bank) { return visit(bank, true) || visit(bank, false); }
  /// `thrifty`: not to food that is too far for this day.
  bool visit(bool bank, bool thrifty) {
    const auto& edges = input_.movement.edges;
    const std::pair key{herd_.species, here()};
    const auto first = std::lower_bound(edges.begin(), edges.end(), key, [](const SpatialEdge& e, const auto& k) {
      return std::pair{e.species, e.from} < k;
    });
    auto last = first;
    while (last != edges.end() && last->species == herd_.species && last->from == here()) ++last;
    const auto offset = std::size_t(first - edges.begin());
    for (const bool crowded : {false, true}) {
      const int drawn = draw(std::size_t(last - first), chance(bank ? 3 : 4), [&](std::size_t i) {
        const SpatialEdge& edge = edges[offset + i];
        const float walk = edge.seconds / 3600;
        if (is_bank(edge.to) != bank || is_waypoint(edge.to) || walk > longest_leg || (!crowded && !room(edge.to, hour_ + walk)))
          return 0.0;
        if (thrifty && !bank && walked_ + walk + hours_home(edge.to) > longest_walk) return 0.0;
        // What lies far from home is for another day.
        return double(input_.movement.travel->onward[offset + i]) / (1 + double(hours_home(edge.to)));
      });
      if (drawn < 0) continue;
      const SpatialEdge& edge = edges[offset + std::size_t(drawn)];
      go(edge.to, edge.seconds / 3600);
      return true;
    }
    return bank && !thrifty && visit_nearest_bank();
  }

  /// Water is a must: where no bank is among the most probable ways onward it goes to the nearest, with room for it if there is
  /// one.
  bool visit_nearest_bank() {
    for (const bool crowded : {false, true}) {
      const auto [bank, walk] = nearest_bank(crowded);
      if (bank < 0) continue;
      go(bank, walk);
      if (walk > far_water) visits_ = drunk_;
      return true;
    }
    return false;
  }
  /// The bank that is reached first from here, and in how many hours; -1 when there is none.
  [[nodiscard]] std::pair<int, float> nearest_bank(bool crowded) const {
    const LevelTravel& travel = *input_.movement.travel;
    const auto number = std::size_t(travel.graph_of_species[std::size_t(day_.species_index)]);
    const TravelGraph& graph = *travel.graphs[number];
    const auto vertex = [&](int node) { return travel.vertex_of_node[number][std::size_t(node)]; };
    std::vector<int> banks;
    std::vector<std::uint16_t> goals(graph.vertices.size(), 0);
    for (const auto& presence : presence_) {
      if (!is_bank(presence.node) || vertex(presence.node) < 0 || presence.node == here()) continue;
      if (!crowded && !room(presence.node, hour_)) continue;
      banks.push_back(presence.node);
      goals[std::size_t(vertex(presence.node))] = 1;
    }
    std::pair<int, float> nearest{-1, 0};
    if (banks.empty() || vertex(here()) < 0) return nearest;
    TravelSearch search(graph, travel.cost(number));
    search.run(std::uint32_t(vertex(here())), goals, 1);
    for (const int bank : banks) {
      const float hours = search.cost(std::uint32_t(vertex(bank))) / animal_->speed / 3600;
      if (std::isfinite(hours) && (nearest.first < 0 || hours < nearest.second)) nearest = {bank, hours};
    }
    return nearest;
  }

  /// Waypoints that are drawn by their attraction, each where it is least out of the way; none that is farther than a walk may
  /// be.
  void add_waypoints() {
    for (const auto& presence : presence_) {
      const ResourceNode& place = node(presence.node);
      if (!is_waypoint(presence.node) || !stands(presence.node)) continue;
      const auto unit = [&](std::uint64_t what) {
        return random_unit({input_.keys[std::size_t(day_.herd)], std::uint64_t(place.x), std::uint64_t(place.y), what});
      };
      if (unit(61) >= double(place.attraction)) continue;
      std::size_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < day_.stays.size(); ++i) {
        const int from = day_.stays[i].node;
        const int to = day_.stays[(i + 1) % day_.stays.size()].node;
        const double more = metres_between(from, presence.node) + metres_between(presence.node, to) - metres_between(from, to);
        if (more >= least) continue;
        least = more;
        best = i;
      }
      if (least * detour / double(animal_->speed) / 3600 > double(longest_leg)) continue;
      const float hours = float(shortest_call + (longest_call - shortest_call) * unit(62));
      day_.stays.insert(day_.stays.begin() + std::ptrdiff_t(best) + 1, PlannedStay{presence.node, hours, 0});
    }
  }
  [[nodiscard]] double metres_between(int a, int b) const {
    return std::hypot(double(node(a).x - node(b).x), double(node(a).y - node(b).y)) * input_.ground.terrain->cell_size;
  }

  [[nodiscard]] bool thirsty() const {
    if (drunk_ >= visits_) return false;
    const float day = spans_.back().until - spans_.front().from;
    return hour_ + 0.5F >= spans_.front().from + day * (float(drunk_) + 0.5F) / float(visits_);
  }

  /// One more stop, or rest until the next active hours; false at the end of the day.
  bool go_on() {
    if (hour_ >= spans_[span_].until) {
      if (span_ + 1 == spans_.size()) return false;
      if (is_bank(here()) && !visit(false)) return false;
      ++span_;
      day_.stays.back().not_before = spans_[span_].from;
      hour_ = std::max(hour_, spans_[span_].from);
      return true;
    }
    if (thirsty() && !is_bank(here())) return visit(true);
    constexpr float shortest_rest = 1.5F;
    if (span_ + 1 == spans_.size() && hour_ + hours_home(here()) + shortest_rest >= spans_.back().until) return false;
    if (visit(false, true)) return true;
    if (is_bank(here())) return visit(false, false);
    stay_longer();
    return true;
  }

  PlanInput input_;
  /// Animals at each node by hour of the day.
  std::vector<std::array<int, 24>> taken_;
  DayDraft day_;
  Herd herd_;
  const AnimalTraits* animal_ = nullptr;
  std::span<const LevelTravel::Presence> presence_;
  std::vector<DailyPlan::Span> spans_;
  std::size_t span_ = 0;
  int home_ = -1;
  int visits_ = 0;
  int drunk_ = 0;
  float hour_ = 0;
  float walked_ = 0;
};

}  // namespace

std::vector<DailyPlan::Span> active_hours(Activity activity) {
  switch (activity) {
    case Activity::diurnal:
      return {{5, 21}};
    case Activity::crepuscular:
      return {{4, 10}, {16, 22}};
    case Activity::nocturnal:
      return {{18, 30}};
    case Activity::cathemeral:
      break;
  }
  return {{3, 8}, {10.5F, 16}, {18.5F, 24}};
}

int species_index_of(const AnimalLevel& level, const Herd& herd) {
  const auto found = std::find(level.species.begin(), level.species.end(), herd.species);
  assert(found != level.species.end());
  return int(found - level.species.begin());
}

std::vector<DayDraft> draft_days(const PlanInput& input, std::span<const std::uint8_t> wanted) {
  Drafter drafter(input);
  std::vector<DayDraft> drafts;
  for (std::size_t herd = 0; herd < wanted.size(); ++herd) {
    if (wanted[herd]) drafts.push_back(drafter.draft(int(herd)));
  }
  return drafts;
}

}  // namespace biotope
