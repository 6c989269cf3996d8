#pragma once

#include <string>
#include <vector>

#include "render/landscape_renderer.hpp"

namespace biotope::test {

/// A picture that is compared from one version to the next.
struct FixedView {
  std::string name;
  Camera camera;
  LandscapeOptions options;
};

/// The dozen views of a landscape: times of day, seasons, weathers, places near and far. A function of the snapshot alone; views
/// of what the landscape has not (a herd that drinks by day, a fork of trails) are left out.
[[nodiscard]] std::vector<FixedView> fixed_views(const MapsSnapshot& snapshot);

/// The ring of a brush of 60 m on the ground in the middle of the landscape, seen from above near by.
[[nodiscard]] FixedView brush_view(const MapsSnapshot& snapshot);

/// Views of a landscape where it snows.
[[nodiscard]] std::vector<FixedView> snow_views(const MapsSnapshot& snapshot);

}  // namespace biotope::test
