#include <algorithm>
#include <cmath>

#include "core/movement/plan_parts.hpp"

namespace biotope {
namespace {

using PlannedDay = std::pair<DailyPlan, HerdCourse>;

/// A stop may come so much before the last one is over and still is meant for the same day: the herd is late. Our choice, h.
constexpr double longest_overlap = 4;
/// A herd is back at its first stop this long before the day begins anew, so that rounding never makes it late, h.
constexpr double margin = 1e-4;
/// Who comes this much before or after the asked hour is not there at that hour, h.
constexpr double minute = 1.0 / 60;

/// A stop that was asked for, with hours that go on from the stop before (they may pass 24).
struct AskedStop {
  int number = 0;  ///< in the edit
  int node = 0;
  double arrive = 0;
  double leave = 0;
};

/// Finds out what one edit asks of one herd.
class EditReader {
 public:
  EditReader(const PlanInput& input, int herd) : level_(input.level), herd_(level_.herds[std::size_t(herd)]) {
    const LevelTravel& travel = *input.movement.travel;
    const auto species = std::size_t(species_index_of(level_, herd_));
    const auto graph = std::size_t(travel.graph_of_species[species]);
    graph_ = travel.graphs[graph].get();
    vertices_ = &travel.vertex_of_node[graph];
    presence_ = travel.presence[species][std::size_t(herd_.region)];
  }

  /// The node a person means: one whose place it is, else one that holds the cell, else the nearest in reach; of several in reach
  /// the one where the herd's species is most, then the first. -1 when those there are not in reach of the herd.
  [[nodiscard]] int node_at(PathPoint at) const {
    const auto& nodes = level_.graph->nodes;
    const PathCell cell = cell_at(at);
    std::vector<int> candidates;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].x == cell.x && nodes[i].y == cell.y) candidates.push_back(int(i));
    }
    if (!candidates.empty()) return likeliest(candidates);
    for (const auto& grid : level_.graph->node_of_cell) {
      if (grid && grid->contains(cell.x, cell.y) && (*grid)(cell.x, cell.y) >= 0) candidates.push_back((*grid)(cell.x, cell.y));
    }
    return candidates.empty() ? nearest(at) : likeliest(candidates);
  }

 private:
  [[nodiscard]] bool in_reach(int node) const {
    const std::int32_t vertex = (*vertices_)[std::size_t(node)];
    return vertex >= 0 && graph_->vertices[std::size_t(vertex)].region == herd_.region;
  }
  [[nodiscard]] float probability(int node) const {
    for (const auto& presence : presence_) {
      if (presence.node == node) return presence.probability;
    }
    return 0;
  }
  [[nodiscard]] int likeliest(const std::vector<int>& candidates) const {
    int best = -1;
    for (const int node : candidates) {
      if (in_reach(node) && (best < 0 || probability(node) > probability(best))) best = node;
    }
    return best;
  }
  [[nodiscard]] int nearest(PathPoint at) const {
    const auto& nodes = level_.graph->nodes;
    const auto distance = [&](int node) {
      return std::hypot(double(at.x) - nodes[std::size_t(node)].x, double(at.y) - nodes[std::size_t(node)].y);
    };
    int best = -1;
    for (int node = 0; node < int(nodes.size()); ++node) {
      if (!in_reach(node)) continue;
      if (best >= 0 &&
          (distance(node) > distance(best) || (distance(node) == distance(best) && probability(node) <= probability(best))))
        continue;
      best = node;
    }
    return best;
  }

  const AnimalLevel& level_;
  const Herd& herd_;
  const TravelGraph* graph_ = nullptr;
  const std::vector<std::int32_t>* vertices_ = nullptr;
  std::span<const LevelTravel::Presence> presence_;
};

/// Stops in reach, with ascending hours; the others are noted in `unreachable`.
std::vector<AskedStop> read_stops(const PlanInput& input, int herd, const PlanEdit& edit, std::vector<int>& unreachable) {
  const EditReader reader(input, herd);
  std::vector<AskedStop> stops;
  for (std::size_t i = 0; i < edit.stops.size(); ++i) {
    const PlanStopEdit& wish = edit.stops[i];
    const int node = reader.node_at(wish.at);
    if (node < 0) {
      unreachable.push_back(int(i));
      continue;
    }
    double arrive = std::fmod(std::fmod(double(wish.arrive), 24.0) + 24.0, 24.0);
    double stay = double(wish.leave) - double(wish.arrive);
    if (stay < 0) stay = std::fmod(stay, 24.0) + 24;
    stay = std::min(stay, 24.0);
    if (!stops.empty()) arrive += 24 * std::max(0.0, std::ceil((stops.back().leave - longest_overlap - arrive) / 24));
    stops.push_back({int(i), node, arrive, arrive + stay});
  }
  return stops;
}

/// The hours at which a herd can do what was asked, `walks[i]` being the time from stop i to the next, the last one home to the
/// first.
std::vector<PlanStop> schedule(const std::vector<AskedStop>& asked, const std::vector<double>& walks) {
  const std::size_t count = asked.size();
  std::vector<double> arrive{asked[0].arrive};
  std::vector<double> leave;
  for (std::size_t i = 0; i < count; ++i) {
    leave.push_back(arrive[i] + (asked[i].leave - asked[i].arrive));
    if (i + 1 == count) break;
    // Who has time left stays until it must go; who has none comes late, and all that follows is later until there is time.
    arrive.push_back(std::max(asked[i + 1].arrive, leave[i] + walks[i]));
    leave[i] = arrive[i + 1] - walks[i];
  }
  leave.back() = arrive.front() + 24 - margin - walks.back();
  // What does not fit before the herd must be back is cut short, from the end.
  for (std::size_t i = count - 1; i > 0; --i) {
    arrive[i] = std::min(arrive[i], leave[i]);
    leave[i - 1] = std::min(leave[i - 1], arrive[i] - walks[i - 1]);
  }
  std::vector<PlanStop> stops;
  for (std::size_t i = 0; i < count; ++i) {
    const float came = i == 0 ? float(arrive[0]) : float(double(stops.back().leave) + walks[i - 1]);
    stops.push_back({asked[i].node, came, std::max(came, float(leave[i]))});
  }
  return stops;
}

/// One herd's edited day.
class EditedDay {
 public:
  EditedDay(const PlanInput& input, int herd, const PlanEdit& edit)
      : input_(input),
        herd_(herd),
        graph_(input.movement.travel
                   ->graph_of_species[std::size_t(species_index_of(input.level, input.level.herds[std::size_t(herd)]))]),
        speed_(double(input.web.species[std::size_t(input.level.herds[std::size_t(herd)].species)].animal().speed)),
        asked_(read_stops(input, herd, edit, unreachable_)) {}

  PlannedDay write() {
    std::optional<NodeWays> ways(std::in_place, input_);
    while (asked_.size() > 1 && !find_walks(*ways)) ways.emplace(input_);
    std::vector<PlanStop> stops;
    if (asked_.size() == 1) {
      const auto arrive = float(asked_[0].arrive);
      stops.push_back({asked_[0].node, arrive, arrive + 24});
      legs_.clear();
    } else if (asked_.size() > 1) {
      stops = schedule(asked_, walks_);
    }
    PlannedDay day = stops.empty() ? PlannedDay{stand_still(input_, herd_), {}} : write_stops(input_, herd_, stops, legs_);
    day.first.edited = true;
    std::sort(unreachable_.begin(), unreachable_.end());
    day.first.unreachable_stops = std::move(unreachable_);
    for (std::size_t i = 1; i < stops.size(); ++i) {
      if (std::abs(double(stops[i].arrive) - asked_[i].arrive) > minute) day.first.shifted_stops.push_back(asked_[i].number);
    }
    return day;
  }

 private:
  /// Ways from each stop to the next; false when a stop had to be left out.
  bool find_walks(NodeWays& ways) {
    legs_.clear();
    walks_.clear();
    const auto next = [&](std::size_t i) { return asked_[(i + 1) % asked_.size()].node; };
    for (std::size_t i = 0; i < asked_.size(); ++i) ways.need(graph_, asked_[i].node, next(i));
    ways.find();
    double sum = 0;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      legs_.push_back(ways.get(graph_, asked_[i].node, next(i)));
      if (!legs_.back()) return leave_out(std::min(i + 1, asked_.size() - 1));
      walks_.push_back(legs_.back()->cost.back() / speed_ / 3600);
      sum += walks_.back();
    }
    // More walking than there is day.
    return sum < 24 - 2 * margin || leave_out(asked_.size() - 1);
  }
  bool leave_out(std::size_t stop) {
    unreachable_.push_back(asked_[stop].number);
    asked_.erase(asked_.begin() + std::ptrdiff_t(stop));
    return false;
  }

  const PlanInput& input_;
  int herd_;
  int graph_;
  double speed_;
  std::vector<int> unreachable_;
  std::vector<AskedStop> asked_;
  std::vector<const NodeWay*> legs_;
  std::vector<double> walks_;
};

}  // namespace

std::vector<std::pair<DailyPlan, HerdCourse>> edited_days(const PlanInput& input, const PlannedEdits& edits) {
  std::vector<PlannedDay> days;
  for (const auto& [herd, edit] : edits) days.push_back(EditedDay(input, herd, *edit).write());
  return days;
}

}  // namespace biotope
