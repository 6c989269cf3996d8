#pragma once

#include <functional>
#include <optional>

#include "core/document/document.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

struct EditorState;

/// What of a stop is held on the bar of the day.
enum class DayGrip : std::uint8_t { none, whole, from, until };

/// The herd whose day is looked at and changed.
struct HerdDay {
  /// Names the herd; its stops are those of the moment it was chosen.
  std::optional<PlanEdit> herd;
  /// A stop being dragged on a view, and the day as it will be.
  int held_stop = -1;
  std::optional<PlanEdit> preview;
  /// A stop being dragged on the bar of the day: which part, and how long after its arrival it was taken.
  DayGrip grip = DayGrip::none;
  float grip_offset = 0;
  /// The next click on a view adds a stop.
  bool adding = false;
};

/// The plan of the herd nearest to a place at this hour, at most `reach` cells away; -1: none.
[[nodiscard]] int herd_near(const MapsSnapshot& maps, const std::vector<bool>& visible_species, double hour, PathPoint at,
                            float reach);

/// Plan of the chosen herd in what is shown; null when it has none.
[[nodiscard]] const DailyPlan* chosen_plan(const EditorState& state);
/// Its day as the person wants it: the document's, or what was computed. Nothing when no herd is chosen.
[[nodiscard]] std::optional<PlanEdit> chosen_day(const EditorState& state);
/// True when the document holds a day for the chosen herd.
[[nodiscard]] bool day_is_edited(const EditorState& state);

/// Where a stop of the chosen herd's day is shown: its resource, or, where a predator visits a herd, where it is at half time.
[[nodiscard]] PathPoint stop_place(const EditorState& state, const PlanEdit& day, std::size_t stop);

/// Chooses the herd under a place; false when there is none.
bool choose_herd(EditorState& state, PathPoint at, float reach);
void forget_herd(EditorState& state);
/// Changes the chosen herd's day, one step.
void change_day(EditorState& state, const std::string& name, const std::function<void(PlanEdit&)>& change);
/// Gives the chosen herd its computed day back.
void restore_day(EditorState& state);

/// Adds a stop of an hour at a place, where the clock stands, in its order.
void add_stop(PlanEdit& day, PathPoint at, double hour);
/// Swaps what two stops are at; their hours stay.
void swap_stops(PlanEdit& day, std::size_t a, std::size_t b);
/// Sets a stop's hours, rounded to five minutes; it stays between its neighbours and lasts at least a quarter of an hour.
void set_hours(PlanEdit& day, std::size_t stop, float arrive, float leave);

/// "resting", "drinking" ...
[[nodiscard]] const char* activity_word(HerdActivity activity);
/// What a resource is called: "Oak, 3.2 ha", "Water", "Red deer, 310 ha".
[[nodiscard]] std::string resource_name(const MapsSnapshot& maps, int level, int node);
/// What a herd is called among those of its species: "Red deer 3", by the order of plans; "nobody" when there is no such plan.
[[nodiscard]] std::string herd_name(const MapsSnapshot& maps, int plan);
/// What a herd does at a stop of its plan: the resource, the herd that a predator visits there, or "Resting place".
[[nodiscard]] std::string stop_name(const MapsSnapshot& maps, const DailyPlan& plan, const PlanStop& stop);
/// "Follows Red deer 3 until 07:40; 12 herds in its day"; empty for those that follow nobody.
[[nodiscard]] std::string pursuit_text(const MapsSnapshot& maps, const DailyPlan& plan, double hour);
/// The node of a level nearest to a place; -1: none.
[[nodiscard]] int node_near(const MapsSnapshot& maps, int level, PathPoint at);

// On the views: press, drag and release at places in cells; true while it belongs to the herd's day.
bool press_day(EditorState& state, PathPoint at, float reach);
void drag_day(EditorState& state, PathPoint at);
void release_day(EditorState& state);

}  // namespace biotope
