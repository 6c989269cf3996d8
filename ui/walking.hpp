#pragma once

#include <glm/glm.hpp>

#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"
#include "render/camera.hpp"

namespace biotope {

// On foot: pure functions of the ground. Lengths in metres east and north of the south-west corner.

inline constexpr double eye_height = 1.7;    ///< m over the ground; our choice: a person's
inline constexpr double deepest_wading = 1;  ///< m of water; our choice: the hips
inline constexpr double steepest_climb = 1;  ///< rise / run; our choice: 45 degrees
inline constexpr double steepest_descent = 1.5;
inline constexpr double pace_on_foot = 2.5;  ///< m/s; our choice: a brisk walk, so that one gets somewhere
inline constexpr double pace_running = 8;    ///< m/s; our choice

/// What one walks on. `water` may be null: dry land.
struct WalkingGround {
  const Terrain& terrain;
  const Hydrology* water = nullptr;
};

/// Depth of the water at a place, m, bilinear between cells.
[[nodiscard]] double water_depth(const WalkingGround& ground, glm::dvec2 at);
/// Whether a short step (half a metre or less) can be made: inside the land, not too steep up or down, not into water deeper than
/// one wades. Out of water that is too deep and off ground that is too steep one always gets.
[[nodiscard]] bool can_step(const WalkingGround& ground, glm::dvec2 from, glm::dvec2 to);
/// Where a walk by `metres` ends: in short steps, along what is in the way where that leads on, never through it.
[[nodiscard]] glm::dvec2 walked(const WalkingGround& ground, glm::dvec2 from, glm::dvec2 metres);
/// The nearest place where one can stand: the place itself, or dry enough and not too steep ground within 400 m; the place where
/// there is none.
[[nodiscard]] glm::dvec2 standing_place(const WalkingGround& ground, glm::dvec2 near);

/// Height of the eyes of who stands there, m: over the ground, or over the surface of water that one swims in.
[[nodiscard]] double eye_level(const WalkingGround& ground, glm::dvec2 at);
/// The camera of a walker after `seconds`: moved by metres to its right and ahead on the level, eyes brought smoothly to their
/// height over the new ground, so that steps and edges do not jolt.
[[nodiscard]] Camera camera_on_foot(const WalkingGround& ground, const Camera& camera, double right, double ahead,
                                    double seconds);

}  // namespace biotope
