#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "core/terrain/terrain.hpp"
#include "render/camera.hpp"

namespace biotope {

/// How long a flight to a place takes, s. Our choice: long enough to follow with the eye, short enough not to wait.
inline constexpr double flight_seconds = 0.6;

/// A smooth way of the camera from one view to another.
struct CameraFlight {
  Camera from;
  Camera to;
  double elapsed = 0;  ///< s
};

/// Degrees of the shortest turn from one heading to another, -180..180.
[[nodiscard]] float shortest_turn(float from, float to);
/// The camera at a moment of a flight: eased at both ends, over what lies between on a low arc, turning the shorter way.
[[nodiscard]] Camera camera_on_flight(const CameraFlight& flight);
[[nodiscard]] inline bool landed(const CameraFlight& flight) { return flight.elapsed >= flight_seconds; }

/// A view of a place on the ground (metres) from `distance` metres: from the side the camera looked from before where the place
/// can be seen from there, else from the side nearest to it that shows it. Never below the ground. `clearness`, where given, is
/// how free the sight is from an eye, 0..1 (plants); `slant` is how many degrees one looks down on level ground.
using Clearness = std::function<double(const glm::dvec3& eye)>;
[[nodiscard]] Camera view_of_place(const Terrain& terrain, const glm::dvec3& place, double distance, const Camera& before,
                                   const Clearness& clearness = {}, double slant = 18);

}  // namespace biotope
