#include "core/exchange/edit_script_json.hpp"
#include "core/exchange/edit_script_open.hpp"

namespace biotope {
namespace {

using namespace script_json;

Json targets_to_json(const std::vector<EditTarget>& targets) {
  Json list = Json::array();
  for (const EditTarget& target : targets) {
    Json json{{"layer", layer_to_text(target.layer)}};
    if (target.weight != 1) json["weight"] = tidy_number(target.weight);
    if (target.value) json["value"] = tidy_number(*target.value);
    if (target.floor) json["floor"] = tidy_number(*target.floor);
    list.push_back(std::move(json));
  }
  return list;
}

/// What strokes and fills have in common.
template <class Entry>
void write_painting(Json& json, const Entry& entry) {
  json["targets"] = targets_to_json(entry.edit.targets);
  json["brush"] = brush_to_json(entry.edit.brush, entry.stamp);
  if (entry.edit.clone_from) json["clone_from"] = layer_to_text(*entry.edit.clone_from);
}

struct Writer {
  Json& json;

  void operator()(const StrokeEntry& entry) const {
    write_painting(json, entry);
    Json& list = json["points"] = Json::array();
    for (const StrokePoint& point : entry.edit.points) {
      list.push_back(point_to_json({point.x, point.y}));
      if (point.pressure != 1) list.back().push_back(tidy_number(point.pressure));
    }
  }
  void operator()(const FillEntry& entry) const {
    write_painting(json, entry);
    if (!entry.edit.gradient) return;
    const auto& gradient = *entry.edit.gradient;
    json["gradient"] = {{"from", point_to_json(gradient.from)},
                        {"to", point_to_json(gradient.to)},
                        {"end_value", tidy_number(gradient.end_value)}};
  }
  void operator()(const SelectEdit& edit) const {
    json["shape"] = shape_words()[std::size_t(edit.shape)];
    json["mode"] = selection_mode_words()[std::size_t(edit.mode)];
    if (!edit.points.empty()) {
      Json& list = json["points"] = Json::array();
      for (const PathPoint& point : edit.points) list.push_back(point_to_json(point));
    }
    if (edit.shape == SelectEdit::Shape::range) json["range"] = condition_to_json(edit.range);
    if (edit.shape == SelectEdit::Shape::painted) json["layer"] = layer_to_text(edit.range.map);
  }
  void operator()(const ClearEdit& edit) const { json["layer"] = layer_to_text(edit.layer); }
  void operator()(const ImageEntry& entry) const {
    json["layer"] = layer_to_text(entry.layer);
    json["file"] = entry.file;
    if (entry.low) json["low"] = tidy_number(*entry.low);
    if (entry.high) json["high"] = tidy_number(*entry.high);
    json["opacity"] = tidy_number(entry.opacity);
    json["filter"] = filter_to_json(entry.filter);
  }
  void operator()(const MixEntry& entry) const {
    json["into"] = layer_to_text(entry.into);
    if (entry.file.empty()) {
      json["from"] = layer_to_text(entry.from);
    } else {
      json["file"] = entry.file;
    }
    json["mix"] = mix_words()[std::size_t(entry.mix)];
  }
  void operator()(const PartsPatch& patch) const { write_parts(json, patch); }
  void operator()(const MaskEntry& entry) const {
    if (!entry.file.empty()) json["file"] = entry.file;
  }
  void operator()(const LockEntry& entry) const {
    if (entry.file.empty()) {
      json["how"] = lock_words()[std::size_t(entry.edit.how)];
    } else {
      json["file"] = entry.file;
    }
  }
  void operator()(const GroupEntry& entry) const;
  void operator()(const UndoEntry& entry) const { json["steps"] = entry.steps; }
  void operator()(const RedoEntry& entry) const { json["steps"] = entry.steps; }
  void operator()(const OpenEntry& entry) const { write_open(json, entry); }
};

Json entry_to_json(const ScriptEntry& entry) {
  Json json{{"edit", entry_kind(entry)}};
  std::visit(Writer{json}, entry.what);
  return json;
}

void Writer::operator()(const GroupEntry& group) const {
  if (!group.name.empty()) json["name"] = group.name;
  Json& list = json["edits"] = Json::array();
  for (const ScriptEntry& entry : group.entries) list.push_back(entry_to_json(entry));
}

}  // namespace

std::string edit_script_to_json(const EditScript& script) {
  Json head{{"format", "biotope-edits"}, {"version", edit_script_version}};
  if (script.width > 0) head["terrain"] = {{"width", script.width}, {"height", script.height}};
  std::string text = head.dump();
  text.pop_back();
  text += ",\n\"edits\": [";
  for (std::size_t i = 0; i < script.entries.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + entry_to_json(script.entries[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + "\n]}\n";
}

}  // namespace biotope
