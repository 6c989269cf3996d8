#include "ui/edit_recorder.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace biotope {
namespace {

/// The name an object has among attachments, or a new one: kind-1.tif, kind-2.tif, ...
template <class Object>
std::string name_among(std::map<std::string, std::shared_ptr<const Object>>& attachments,
                       const std::shared_ptr<const Object>& object, const std::string& kind) {
  for (const auto& [name, held] : attachments) {
    if (held == object) return name;
  }
  const std::string name = kind + "-" + std::to_string(attachments.size() + 1) + ".tif";
  attachments[name] = object;
  return name;
}

template <class T>
bool same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

bool same_given(const GivenEnvironment& a, const GivenEnvironment& b) { return a.monthly == b.monthly && a.geology == b.geology; }

std::shared_ptr<const PaintLayer> paint_on(const Document& document, const LayerId& layer) {
  const auto found = document.layers.find(layer);
  return found == document.layers.end() ? nullptr : found->second;
}

}  // namespace

void EditRecorder::start(const Document& document, std::size_t step) {
  *this = {};
  recording_ = true;
  before_ = now_ = document;
  step_ = step;
  if (!document.terrain) return;
  script_.width = document.terrain->height.width();
  script_.height = document.terrain->height.height();
}

void EditRecorder::follow(const Document& after, std::size_t step) {
  now_ = after;
  step_ = step;
  saved_ = false;
}

void EditRecorder::record(const Edit& edit, const Document& after, std::size_t step) {
  if (!recording_) return;
  const bool parts = std::holds_alternative<PartsEdit>(edit);
  if (parts && may_merge_ && step == step_) {
    script_.entries.back() = difference(before_, after, std::get<PartsEdit>(edit).name);
  } else {
    before_ = now_;
    script_.entries.push_back(entry_of(edit, after));
    ++undoable_;
    redoable_ = 0;
  }
  may_merge_ = parts;
  follow(after, step);
}

void EditRecorder::record_open(const std::string& input, const DemImportOptions& options, const Document& after) {
  if (!recording_) return;
  static constexpr std::string_view sample = "sample:";
  const bool built_in = input.starts_with(sample);
  std::error_code error;
  const std::string file = built_in ? std::string() : std::filesystem::absolute(input, error).string();
  script_.entries.push_back({OpenEntry{built_in ? input.substr(sample.size()) : std::string(), file, options}});
  may_merge_ = false;
  undoable_ = redoable_ = 0;
  before_ = after;
  follow(after, 0);
}

void EditRecorder::record_undo(const Document& after, std::size_t step) {
  if (!recording_) return;
  may_merge_ = false;
  if (undoable_ > 0) {
    auto* last = script_.entries.empty() ? nullptr : std::get_if<UndoEntry>(&script_.entries.back().what);
    if (last) {
      ++last->steps;
    } else {
      script_.entries.push_back({UndoEntry{}});
    }
    --undoable_;
    ++redoable_;
  } else {
    write_difference(after);
  }
  follow(after, step);
}

void EditRecorder::record_redo(const Document& after, std::size_t step) {
  if (!recording_) return;
  may_merge_ = false;
  if (redoable_ > 0) {
    auto* last = std::get_if<RedoEntry>(&script_.entries.back().what);
    if (last) {
      ++last->steps;
    } else {
      script_.entries.push_back({RedoEntry{}});
    }
    --redoable_;
    ++undoable_;
  } else {
    write_difference(after);
  }
  follow(after, step);
}

/// What was done before the recording began is no step of the script: neither undo nor redo may reach beyond this one.
void EditRecorder::write_difference(const Document& after) {
  script_.entries.push_back(difference(now_, after, "Go in the history"));
  undoable_ = redoable_ = 0;
}

ScriptEntry EditRecorder::entry_of(const Edit& edit, const Document& after) {
  if (const auto* stroke = std::get_if<StrokeEdit>(&edit)) return entry_of(*stroke, after);
  if (const auto* fill = std::get_if<FillEdit>(&edit)) return entry_of(*fill, after);
  if (const auto* select = std::get_if<SelectEdit>(&edit)) return {*select};
  if (const auto* clear = std::get_if<ClearEdit>(&edit)) return {*clear};
  if (const auto* image = std::get_if<ImageEdit>(&edit)) return entry_of(*image, after);
  if (const auto* mix = std::get_if<MixEdit>(&edit)) return entry_of(*mix, after);
  if (const auto* lock = std::get_if<LockEdit>(&edit)) return {LockEntry{*lock, {}}};
  return entry_of(std::get<PartsEdit>(edit), after);
}

ScriptEntry EditRecorder::entry_of(const StrokeEdit& edit, const Document&) {
  StrokeEntry entry{edit, raster_name(edit.brush.stamp, "stamp")};
  entry.edit.brush.stamp = nullptr;
  return {std::move(entry)};
}

ScriptEntry EditRecorder::entry_of(const FillEdit& edit, const Document&) {
  FillEntry entry{edit, {}};
  entry.edit.brush.stamp = nullptr;
  return {std::move(entry)};
}

ScriptEntry EditRecorder::entry_of(const ImageEdit& edit, const Document&) {
  return {ImageEntry{edit.layer, raster_name(edit.values, "image"), {}, {}, edit.opacity, edit.filter}};
}

ScriptEntry EditRecorder::entry_of(const MixEdit& edit, const Document&) {
  return {MixEntry{edit.into, edit.from, edit.mix, paint_name(edit.paint)}};
}

ScriptEntry EditRecorder::entry_of(const PartsEdit& edit, const Document& after) { return difference(now_, after, edit.name); }

ScriptEntry EditRecorder::difference(const Document& before, const Document& after, const std::string& name) {
  if (before.terrain != after.terrain || !same_given(before.given_environment, after.given_environment)) ++missed_;
  PartsPatch parts = patch_between(before, after);
  parts.name = name;
  std::vector<ScriptEntry> layers;
  add_layer_differences(before, after, layers);
  const bool selection = !same(before.selection, after.selection);
  const bool locks = !same(before.locked_area, after.locked_area);
  if (layers.empty() && !selection && !locks) return {std::move(parts)};

  GroupEntry group{name, {}};
  if (!layers.empty()) {
    // Neither locks, nor the selection, nor species that are not there yet may keep paint from becoming what it became.
    PartsPatch first;
    if (!before.layer_states.empty()) {
      first.layer_states.emplace();
      parts.layer_states = after.layer_states;
    }
    if (parts.species && !parts.species->changed.empty()) first.species = SpeciesPatch{parts.species->changed, {}, {}};
    if (!first.empty()) group.entries.push_back({std::move(first)});
    if (before.selection) group.entries.push_back({MaskEntry{}});
    if (before.locked_area) group.entries.push_back({LockEntry{{LockEdit::How::nothing}, {}}});
    std::move(layers.begin(), layers.end(), std::back_inserter(group.entries));
  }
  if (!parts.empty()) group.entries.push_back({std::move(parts)});
  if (selection || before.selection) group.entries.push_back({MaskEntry{mask_name(after.selection)}});
  if (locks || (before.locked_area && !layers.empty())) {
    const LockEdit none{LockEdit::How::nothing};
    group.entries.push_back({LockEntry{none, mask_name(after.locked_area)}});
  }
  return {std::move(group)};
}

void EditRecorder::add_layer_differences(const Document& before, const Document& after, std::vector<ScriptEntry>& entries) {
  std::set<LayerId> layers;
  for (const auto& [layer, paint] : before.layers) layers.insert(layer);
  for (const auto& [layer, paint] : after.layers) layers.insert(layer);
  for (const LayerId& layer : layers) {
    const auto was = paint_on(before, layer);
    const auto is = paint_on(after, layer);
    if (same(was, is)) continue;
    if (is && is->bytes() > 0) {
      entries.push_back({MixEntry{layer, layer, LayerMix::replace, paint_name(is)}});
    } else if (was && was->bytes() > 0) {
      entries.push_back({ClearEdit{layer}});
    }
  }
}

std::string EditRecorder::raster_name(const std::shared_ptr<const Grid<float>>& raster, const char* kind) {
  return raster ? name_among(attachments_.rasters, raster, kind) : std::string();
}

std::string EditRecorder::paint_name(const std::shared_ptr<const PaintLayer>& paint) {
  return paint ? name_among(attachments_.paints, paint, "paint") : std::string();
}

std::string EditRecorder::mask_name(const std::shared_ptr<const SelectionMask>& mask) {
  return mask ? name_among(attachments_.masks, mask, "mask") : std::string();
}

}  // namespace biotope
