#include <algorithm>
#include <array>

#include "core/exchange/edit_script_json.hpp"
#include "core/exchange/scene_json.hpp"

namespace biotope {
namespace script_json {
namespace {

template <std::size_t count>
using Words = std::array<std::string, count>;

}  // namespace

std::span<const std::string> layer_kind_words() {
  static const Words<7> words{"resource", "plant-density", "animal-density", "geology", "loss", "passage", "ground"};
  return words;
}

std::span<const std::string> brush_mode_words() {
  static const Words<10> words{"add",   "subtract",         "set",   "smooth", "sharpen", "noise",
                               "clone", "restore-computed", "raise", "lower"};
  return words;
}

std::span<const std::string> falloff_words() {
  static const Words<4> words{"smooth", "linear", "sphere", "sharp"};
  return words;
}

std::span<const std::string> quantity_words() {
  static const Words<5> words{"slope", "altitude", "aspect", "water-distance", "map"};
  return words;
}

std::span<const std::string> shape_words() {
  static const Words<7> words{"everything", "nothing", "rectangle", "lasso", "range", "inverse", "painted"};
  return words;
}

std::span<const std::string> selection_mode_words() {
  static const Words<4> words{"replace", "add", "subtract", "intersect"};
  return words;
}

std::span<const std::string> mix_words() {
  static const Words<6> words{"replace", "over", "under", "subtract", "intersect", "maximum"};
  return words;
}

std::span<const std::string> lock_words() {
  static const Words<4> words{"replace", "add", "subtract", "nothing"};
  return words;
}

}  // namespace script_json

std::string layer_to_text(const LayerId& layer) {
  return script_json::layer_kind_words()[std::size_t(layer.kind)] + ":" + layer.name;
}

std::optional<LayerId> layer_from_text(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon + 1 == text.size()) return std::nullopt;
  const auto kinds = script_json::layer_kind_words();
  const auto kind = std::find(kinds.begin(), kinds.end(), text.substr(0, colon));
  if (kind == kinds.end()) return std::nullopt;
  const LayerId layer{LayerKind(kind - kinds.begin()), std::string(text.substr(colon + 1))};
  const auto names = layer_names(layer.kind);
  if (!names.empty() && std::find(names.begin(), names.end(), layer.name) == names.end()) return std::nullopt;
  return layer;
}

std::string entry_kind(const ScriptEntry& entry) {
  static const std::array<std::string, 13> kinds{"stroke", "fill", "select", "clear", "image", "mix", "set",
                                                 "mask",   "lock", "group",  "undo",  "redo",  "open"};
  static_assert(std::variant_size_v<decltype(ScriptEntry::what)> == std::tuple_size_v<decltype(kinds)>);
  return kinds[entry.what.index()];
}

}  // namespace biotope
