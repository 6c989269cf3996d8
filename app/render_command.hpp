#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "app/command_line_options.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "render/weather.hpp"

namespace biotope {

struct RenderRequest {
  LandscapeRequest landscape;
  /// PNG to write; with a path, the folder of its pictures, or an MP4.
  std::string picture;
  /// JSON file with the camera's path; empty: one picture.
  std::string path_file;
  double frames_a_second = 25;
  PictureSize size;
  /// Where to look from; absent: the landscape's own first view.
  std::optional<ViewRequest> view;
  double hour = 10.5;  ///< local solar time, 0..24
  int month = 6;       ///< 1 is January
  Weather weather;
  double seconds = 0;  ///< time of what moves: leaves, waves, rain
  double quality = 2;  ///< 0.5 low, 1 medium, 2 high
};

/// Draws a computed landscape into the request's picture; needs a current OpenGL context.
[[nodiscard]] Status write_picture(const std::shared_ptr<const MapsSnapshot>& snapshot, const RenderRequest& request,
                                   const TaskContext& task = {});

/// Computes a landscape and draws it in 3D into a PNG, or along a path into many or a video; needs no display.
[[nodiscard]] Status run_render(const RenderRequest& request, std::ostream& out, std::ostream& err);

}  // namespace biotope
