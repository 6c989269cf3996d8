#include "ui/landscape_drape.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "ui/editor_actions.hpp"

namespace biotope {

constexpr float seen_through = 0.8F;                       // of the map's opacity: trees and relief are seen through it
constexpr std::chrono::milliseconds longest_colouring{4};  // in a frame
constexpr int rows_of_a_band = 32;

bool drapes_map(const EditorState& state) {
  if (!state.has_document) return false;
  if (state.view.drape) return true;
  if (!state.view.drape_while_painting || !is_painting(state.tool)) return false;
  const std::optional<LayerId> target = paint_target(state);
  return target && target->kind != LayerKind::ground;
}

Result<LandscapeDrape> LandscapeDrape::create() {
  auto drape = MapDrape::create();
  if (!drape) return tl::unexpected(drape.error());
  LandscapeDrape made;
  made.drape_ = std::move(*drape);
  return made;
}

DrapeSource LandscapeDrape::wanted(EditorState& state) {
  DrapeSource source;
  if (drapes_map(state)) {
    follow_shown_map(state, map_);
    source.overlay = overlay_of(state, map_);
    if (source.overlay) source.overlay->opacity *= seen_through;
  }
  // Who only looks is not shown where one may paint.
  if (!is_painting(state.tool) && !is_selecting(state.tool)) return source;
  const BrushFilter& filter = state.brush.filter;
  const bool filters = !filter.conditions.empty() || (state.document.selection && filter.use_selection);
  if (state.paint.show_filter && filters && state.shown) {
    // Maps that are still being made, or change under the brush, are shown as they were last.
    const bool ready = !state.painting.stroking() && state.grounds.ready(*state.shown, state.document, filter);
    if (ready) {
      source.film = DrapeSource::Film{filter, state.grounds.filters(*state.shown, state.document, filter),
                                      filter.use_selection ? state.document.selection : nullptr};
    } else {
      source.film = source_.film;
    }
  }
  source.locked_area = state.document.locked_area;
  return source;
}

void LandscapeDrape::refresh(const DrapeSource& source, const Rect& map, const Rect& changed) {
  const int step = drape_step(map.width(), map.height());
  const int width = (map.width() + step - 1) / step;
  const int height = (map.height() + step - 1) / step;
  const bool goes_on = shown_ && step == step_ && texels_.width() == width && texels_.height() == height;
  if (!goes_on) {
    texels_ = Grid<Rgba>(width, height);
    drape_.set_texels(texels_);
    step_ = step;
    shown_ = true;
  }
  if (!goes_on || !same_drape(source, source_)) {
    source_ = source;
    next_row_ = 0;
  }
  if (!changed.empty()) {
    colour_drape(source, step, changed, texels_);
    drape_.patch(texels_, {changed.x0 / step, changed.y0 / step, changed.x1 / step + 1, changed.y1 / step + 1});
  }
  colour_on(map);
}

void LandscapeDrape::colour_on(const Rect& map) {
  const auto until = std::chrono::steady_clock::now() + longest_colouring;
  while (next_row_ < texels_.height()) {
    const int last = std::min(next_row_ + rows_of_a_band, texels_.height());
    colour_drape(source_, step_, {map.x0, next_row_ * step_, map.x1, std::min(last * step_, map.y1)}, texels_);
    drape_.patch(texels_, {0, next_row_, texels_.width(), last});
    next_row_ = last;
    if (std::chrono::steady_clock::now() >= until) return;
  }
}

void LandscapeDrape::draw(const UiContext& ui, ImDrawList& list, const LandscapeOverlay::Picture& picture, unsigned colours) {
  EditorState& state = ui.state;
  if (!state.document.terrain) return;
  const DrapeSource source = wanted(state);
  if (!source.overlay && !source.film && !source.locked_area) {
    shown_ = false;
    return;
  }
  const Terrain& terrain = *state.document.terrain;
  const Rect map = terrain.height.rect();
  refresh(source, map, state.painting.take_changed(PaintSession::Reader::landscape));
  origin_ = picture.origin;
  picture_.camera = picture.camera;
  picture_.size = {picture.size.x, picture.size.y};
  picture_.depth = picture.depth;
  picture_.colours = colours;
  picture_.ground = {float(terrain.width_metres()), float(terrain.height_metres())};
  picture_.covered = {float(map.width()) / float(texels_.width() * step_), float(map.height()) / float(texels_.height() * step_)};
  list.AddCallback(&LandscapeDrape::draw_now, this);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

void LandscapeDrape::draw_now(const ImDrawList*, const ImDrawCmd* command) {
  const auto& self = *static_cast<const LandscapeDrape*>(command->UserCallbackData);
  const ImVec2 corner = self.origin_;
  set_overlay_viewport(*command, corner, ImVec2(self.picture_.size.x, self.picture_.size.y));
  self.drape_.draw(self.picture_);
}

}  // namespace biotope
