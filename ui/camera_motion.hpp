#pragma once

#include <optional>

#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"
#include "render/camera.hpp"
#include "ui/view_transform.hpp"

namespace biotope {

/// Direction of the ray through a pixel of a canvas.
[[nodiscard]] glm::vec3 ray_through(const Camera& camera, PixelPoint canvas, PixelPoint pixel);
/// Pixel of a place in metres; nothing when it lies behind the camera.
[[nodiscard]] std::optional<PixelPoint> pixel_of(const Camera& camera, PixelPoint canvas, const glm::dvec3& place);
/// Turned in place by degrees; pitch is kept within what is not upside down.
[[nodiscard]] Camera turned(const Camera& camera, float right, float up);
/// Carried around a point by degrees, looking at it as before.
[[nodiscard]] Camera orbited(const Camera& camera, const glm::dvec3& around, float right, float up);
/// Moved by metres along its own axes.
[[nodiscard]] Camera moved(const Camera& camera, double right, double forward, double up);
/// Never below `clearance` metres over the ground and the surface of `water` (may be null: dry land), nor lost far outside the
/// landscape.
[[nodiscard]] Camera kept_over_ground(const Camera& camera, const Terrain& terrain, double clearance = 1.5,
                                      const Hydrology* water = nullptr);

/// Cell coordinates of a place in metres, and back.
[[nodiscard]] PathPoint cell_of(const Terrain& terrain, const glm::dvec3& place);
[[nodiscard]] glm::dvec3 place_of(const Terrain& terrain, PathPoint cell);

}  // namespace biotope
