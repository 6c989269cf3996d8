#include "ui/landscape_overlay.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>

#include "render/landscape_renderer.hpp"
#include "ui/camera_motion.hpp"

namespace biotope {
namespace {

constexpr double step_metres = 12;  // of a line that lies on the ground
constexpr double lift = 0.3;        // over it, m
constexpr float dash = 7;           // at scale 1
constexpr float nearest = 0.2F;     // m

glm::vec4 colour_of(ImU32 packed) {
  const ImVec4 colour = ImGui::ColorConvertU32ToFloat4(packed);
  return {colour.x, colour.y, colour.z, colour.w};
}

OverlayLine styled(const LineLook& look, float scale) {
  OverlayLine line;
  line.colour = colour_of(look.colour);
  line.casing = colour_of(look.casing);
  line.width = look.width * scale;
  line.casing_width = look.casing_width * scale;
  line.dash = look.dashed ? dash * scale : 0;
  return line;
}

}  // namespace

Result<LandscapeOverlay> LandscapeOverlay::create() {
  auto lines = OverlayLines::create();
  if (!lines) return tl::unexpected(lines.error());
  LandscapeOverlay overlay;
  overlay.lines_ = std::move(*lines);
  return overlay;
}

void LandscapeOverlay::begin(ImDrawList& list, const Picture& picture) {
  picture_ = picture;
  vertices_.clear();
  list.AddCallback(&LandscapeOverlay::draw_now, this);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

void LandscapeOverlay::add(OverlayLine line) {
  add_ribbon(line, picture_.camera, {picture_.size.x, picture_.size.y}, nearest, vertices_);
}

void LandscapeOverlay::add_way(std::span<const glm::dvec3> places, const LineLook& look) {
  OverlayLine line = styled(look, picture_.scale);
  line.points.assign(places.begin(), places.end());
  add(std::move(line));
}

ViewPen LandscapeOverlay::pen(const Terrain& ground) {
  const auto on_screen = [this, &ground](PathPoint cell) -> std::optional<ImVec2> {
    const PixelPoint canvas{double(picture_.size.x), double(picture_.size.y)};
    const auto at = pixel_of(picture_.camera, canvas, place_of(ground, cell));
    if (!at) return std::nullopt;
    return ImVec2(picture_.origin.x + float(at->x), picture_.origin.y + float(at->y));
  };
  const auto line = [this, &ground](std::span<const PathPoint> points, const LineLook& look) {
    OverlayLine laid = styled(look, picture_.scale);
    const auto step = float(step_metres / ground.cell_size);
    for (const PathPoint& cell : along_ground(points, step)) {
      laid.points.push_back(place_of(ground, cell) + glm::dvec3(0, 0, lift));
    }
    add(std::move(laid));
  };
  const auto hidden = [this, &ground](PathPoint cell) {
    return hidden_by_ground(ground, picture_.camera.position, place_of(ground, cell));
  };
  return {on_screen, line, hidden};
}

void set_overlay_viewport(const ImDrawCmd& command, ImVec2 origin, ImVec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 scale = io.DisplayFramebufferScale;
  const float bottom = io.DisplaySize.y * scale.y;
  const auto pixels = [](float value) { return GLint(value + 0.5F); };
  const ImVec4& clip = command.ClipRect;
  glViewport(pixels(origin.x * scale.x), pixels(bottom - (origin.y + size.y) * scale.y), pixels(size.x * scale.x),
             pixels(size.y * scale.y));
  glEnable(GL_SCISSOR_TEST);
  glScissor(pixels(clip.x * scale.x), pixels(bottom - clip.w * scale.y), std::max(pixels((clip.z - clip.x) * scale.x), 0),
            std::max(pixels((clip.w - clip.y) * scale.y), 0));
}

void LandscapeOverlay::draw_now(const ImDrawList*, const ImDrawCmd* command) {
  const auto& self = *static_cast<const LandscapeOverlay*>(command->UserCallbackData);
  if (self.vertices_.empty()) return;
  const Picture& picture = self.picture_;
  set_overlay_viewport(*command, picture.origin, picture.size);
  self.lines_.draw(self.vertices_, picture.depth, {picture.size.x, picture.size.y});
}

bool hidden_by_ground(const Terrain& ground, const glm::dvec3& eye, const glm::dvec3& place) {
  constexpr double beside = 2;  // m: what stands on the ground is not hidden by the ground it stands on
  const glm::dvec3 way = place - eye;
  const double distance = glm::length(way);
  const double reach = 0.985 * distance - beside;
  if (reach <= 0) return false;
  return pick_ground(ground, eye, glm::vec3(way), reach).has_value();
}

bool ring_in_picture(const Terrain& ground, const Camera& camera, const glm::vec2& size, PathPoint centre, float radius) {
  const std::vector<PathPoint> ring = ring_around(centre, radius);
  return std::any_of(ring.begin(), ring.end(), [&](PathPoint cell) {
    const auto at = pixel_of(camera, {double(size.x), double(size.y)}, place_of(ground, cell));
    return at && at->x >= 0 && at->y >= 0 && at->x < double(size.x) && at->y < double(size.y);
  });
}

}  // namespace biotope
