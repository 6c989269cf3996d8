#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/base/path_point.hpp"
#include "core/terrain/terrain.hpp"
#include "render/camera.hpp"
#include "render/plant_placement.hpp"
#include "ui/camera_flight.hpp"
#include "ui/follow_arm.hpp"

namespace biotope {

struct EditorState;

/// How one gets around in the 3D view.
struct Exploring {
  /// On foot, at eye height, instead of flying.
  bool walking = false;
  /// The camera goes along with the chosen herd.
  bool following = false;
  /// The animal of the herd that is followed, by its number; -1: the herd as a whole.
  int member = -1;
  /// Where what is followed is in this frame, m.
  std::optional<glm::dvec3> followed;
  /// From the followed herd to the camera, m, and how the camera is pitched; kept while the herd moves.
  struct Arm {
    glm::dvec3 offset{0};
    float pitch = 0;
  };
  std::optional<Arm> arm;
  /// How much of it is used, so that no tree stands between.
  FollowArm sight;
  std::optional<CameraFlight> flight;
  /// The ford or exit that was gone to last, by its number in the list of all.
  int last_crossing = -1;
  /// Width over height of the 3D view.
  float aspect = 1.5F;
  /// Where the plants that are drawn stand; it has no snapshot while none are.
  PlantPlacement plants;
  /// Cell under the pointer in the 3D view, for the map's cursor.
  std::optional<PathPoint> pointer;
  /// The brush under the pointer of the 3D view is so wide that its ring lies outside the picture.
  bool ring_out_of_sight = false;
};

/// Ground under the 3D view as it is drawn: what is shown where it is of this landscape, else the document's.
[[nodiscard]] const Terrain& ground_of(const EditorState& state);
/// The water of that ground as far as it is known; may be null.
[[nodiscard]] const Hydrology* water_of(const EditorState& state);

/// Flies the camera to a view; a jump on foot ends in walking on from there.
void fly_to(EditorState& state, const Camera& camera);
/// Flies to a place in cells, to see it from `distance` metres, shows the 3D view and brings the place to the middle of the map.
void show_place(EditorState& state, PathPoint cell, double distance = 120);
/// Starts and ends walking.
void set_walking(EditorState& state, bool walking);
/// Starts walking at a place in cells.
void walk_at(EditorState& state, PathPoint cell);

/// Plans of the snapshot, in their order, of the chosen herd's species; when no herd is chosen, of the species that is, or where that
/// has no plan of all visible ones. -1 when there is none. `step` is 1 for the next and -1 for the one before.
[[nodiscard]] int neighbouring_plan(const EditorState& state, int step);
/// Chooses the herd of a plan of what is shown; false when it cannot be named.
bool choose_plan(EditorState& state, int plan);
/// Chooses the herd of a species that is nearest to the camera; for -1 of the chosen species, or where that has no plan of any
/// visible one. False when there is none.
bool choose_nearest_herd(EditorState& state, int species = -1);
/// Where the chosen herd is now, m; nothing when no herd is chosen or it has no place.
[[nodiscard]] std::optional<glm::dvec3> chosen_herd_place(const EditorState& state);
/// Flies to the chosen herd.
void go_to_herd(EditorState& state);
/// Flies to the chosen herd and goes along with it, or stops doing so.
void set_following(EditorState& state, bool following);

/// Once a frame, before the 3D view is drawn and after `followed` has been set: flights, the followed herd. True while the camera
/// moves by itself.
bool advance_exploring(EditorState& state, double seconds);
/// The person moved the camera while a herd was followed: from now on it is seen from there.
void keep_arm(EditorState& state);
/// Whatever moves the camera by itself ends: the person takes it.
void take_camera(EditorState& state);

}  // namespace biotope
