#include "ui/shown_map.hpp"

#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/map_furniture.hpp"

namespace biotope {

void follow_shown_map(EditorState& state, ShownMap& map) {
  const FoodWeb* web = state.web();
  const MapId id = visible_map(state);
  const MapId painted_map = web != nullptr && state.painting.shown() ? map_of_layer(state.painting.layer(), *web) : MapId{};
  if (id.kind != MapKind::none && painted_map == id) {
    if (map.id != id) map.values = {};
    map.values.cells = state.painting.shown();
    map.values.low = std::min(map.values.low, state.painting.least());
    map.values.high = std::max(map.values.high, state.painting.greatest());
    map.current = true;
  } else {
    auto answer = state.maps.request(state.newest, id);
    if (!answer.values.cells && state.shown != state.newest) answer = state.maps.request(state.shown, id);
    map.values = answer.values;
    map.current = answer.current;
  }
  map.id = id;
}

std::optional<MapOverlay> overlay_of(const EditorState& state, const ShownMap& map) {
  if (!map.values.cells || map.id.kind == MapKind::none) return std::nullopt;
  const MapEntry entry = describe_map(map.id, state.web());
  const ScaleRange range = scale_range(entry, map.values.low, map.values.high);
  return MapOverlay{map.values.cells, range.low, range.high, entry.colours, state.view.opacity, entry.clear_below};
}

}  // namespace biotope
