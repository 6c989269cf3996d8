#include <algorithm>

#include "core/exchange/edit_script_json.hpp"
#include "core/exchange/edit_script_open.hpp"
#include "core/exchange/height_source.hpp"

namespace biotope {
namespace {

using namespace script_json;

constexpr int most_steps = 1000000;
constexpr Limits weight_limits{0, 1};

bool are_numbers(const Json& list, std::size_t least, std::size_t most, Limits limits) {
  return list.is_array() && list.size() >= least && list.size() <= most &&
         std::all_of(list.begin(), list.end(), [&](const Json& number) {
           return number.is_number() && number.get<double>() >= limits.low && number.get<double>() <= limits.high;
         });
}

void read_stroke_points(JsonReader& reader, std::vector<StrokePoint>& points) {
  const std::string_view expected = "a list of points [x, y] or [x, y, pressure], in cells and 0..1";
  const Json* const list = reader.value("points", Presence::required, expected);
  if (!list) return;
  if (!list->is_array() || list->empty()) return reader.refuse("points", expected, *list);
  points.reserve(list->size());
  for (const Json& item : *list) {
    if (!are_numbers(item, 2, 3, position_limits)) return reader.refuse("points", expected, item);
    StrokePoint point{item[0].get<float>(), item[1].get<float>(), 1};
    if (item.size() == 3) point.pressure = item[2].get<float>();
    if (!(point.pressure >= 0 && point.pressure <= 1)) return reader.refuse("points", expected, item);
    points.push_back(point);
  }
}

void read_path(JsonReader& reader, std::size_t least, std::vector<PathPoint>& points) {
  const std::string expected = "a list of at least " + std::to_string(least) + " points [x, y] in cells";
  const Json* const list = reader.value("points", least > 0 ? Presence::required : Presence::optional, expected);
  if (!list) return;
  if (!list->is_array() || list->size() < least) return reader.refuse("points", expected, *list);
  for (const Json& item : *list) {
    if (!are_numbers(item, 2, 2, position_limits)) return reader.refuse("points", expected, item);
    points.push_back({item[0].get<float>(), item[1].get<float>()});
  }
}

void read_optional_number(JsonReader& reader, std::string_view key, std::optional<float>& target) {
  if (reader.value(key, Presence::optional, "a number")) reader.number(key, target.emplace(), value_limits);
}

void read_targets(JsonReader& reader, std::vector<EditTarget>& targets, const EntryReading& at) {
  const std::string_view expected = "a list of at least one layer to paint";
  const Json* const list = reader.value("targets", Presence::required, expected);
  if (!list) return;
  if (!list->is_array() || list->empty()) return reader.refuse("targets", expected, *list);
  for (std::size_t i = 0; i < list->size() && reader.ok(); ++i) {
    JsonReader one((*list)[i], at.where + ", target " + std::to_string(i + 1), at.problem);
    EditTarget target;
    read_layer(one, "layer", target.layer);
    one.number("weight", target.weight, weight_limits);
    read_optional_number(one, "value", target.value);
    read_optional_number(one, "floor", target.floor);
    one.finish();
    targets.push_back(std::move(target));
  }
}

template <class Entry>
void read_painting(JsonReader& reader, Entry& entry, const EntryReading& at) {
  read_targets(reader, entry.edit.targets, at);
  read_brush(reader, entry.edit.brush, entry.stamp, at);
  if (reader.value("clone_from", Presence::optional, "a layer"))
    read_layer(reader, "clone_from", entry.edit.clone_from.emplace());
  if (entry.edit.brush.mode == BrushMode::clone && !entry.edit.clone_from && at.problem.empty()) {
    at.problem = at.where + ": \"clone_from\" is missing; a brush of mode \"clone\" needs the layer that it takes from";
  }
}

StrokeEntry read_stroke(JsonReader& reader, const EntryReading& at) {
  StrokeEntry entry;
  read_painting(reader, entry, at);
  read_stroke_points(reader, entry.edit.points);
  return entry;
}

FillEntry read_fill(JsonReader& reader, const EntryReading& at) {
  FillEntry entry;
  read_painting(reader, entry, at);
  if (reader.value("gradient", Presence::optional, "an object {...}")) {
    JsonReader line = reader.nested("gradient", Presence::required);
    entry.edit.gradient = FillEdit::Gradient{};
    FillEdit::Gradient& gradient = *entry.edit.gradient;
    read_point(line, "from", gradient.from);
    read_point(line, "to", gradient.to);
    line.number("end_value", gradient.end_value, value_limits, Presence::required);
    line.finish();
  }
  return entry;
}

SelectEdit read_select(JsonReader& reader) {
  using Shape = SelectEdit::Shape;
  SelectEdit edit;
  read_word(reader, "shape", shape_words(), edit.shape, Presence::required);
  read_word(reader, "mode", selection_mode_words(), edit.mode);
  read_path(reader, edit.shape == Shape::rectangle ? 2 : edit.shape == Shape::lasso ? 3 : 0, edit.points);
  if (edit.shape == Shape::range) {
    JsonReader range = reader.nested("range", Presence::required);
    read_condition(range, edit.range);
    range.finish();
  }
  if (edit.shape == Shape::painted) read_layer(reader, "layer", edit.range.map);
  return edit;
}

ImageEntry read_image(JsonReader& reader, const EntryReading& at) {
  ImageEntry entry;
  read_layer(reader, "layer", entry.layer);
  read_file_name(reader, "file", entry.file, Presence::required);
  read_optional_number(reader, "low", entry.low);
  read_optional_number(reader, "high", entry.high);
  reader.number("opacity", entry.opacity, {0, 1});
  read_filter(reader, entry.filter, at);
  return entry;
}

MixEntry read_mix(JsonReader& reader) {
  MixEntry entry;
  read_layer(reader, "into", entry.into);
  read_word(reader, "mix", mix_words(), entry.mix, Presence::required);
  read_file_name(reader, "file", entry.file, Presence::optional);
  if (entry.file.empty()) {
    read_layer(reader, "from", entry.from);
  } else {
    entry.from = entry.into;
  }
  return entry;
}

LockEntry read_lock(JsonReader& reader) {
  LockEntry entry;
  read_file_name(reader, "file", entry.file, Presence::optional);
  if (entry.file.empty()) read_word(reader, "how", lock_words(), entry.edit.how, Presence::required);
  return entry;
}

template <class Entry>
Entry read_steps(JsonReader& reader) {
  Entry entry;
  reader.number("steps", entry.steps, {1, most_steps});
  return entry;
}

std::vector<ScriptEntry> read_entries(const Json& list, const std::string& where, const char* what, bool inside_group,
                                      std::string& problem);

ScriptEntry read_entry(const Json& json, const std::string& where, bool inside_group, std::string& problem) {
  static const std::array<std::string, 13> all{"stroke", "fill", "select", "clear", "image", "mix", "set",
                                               "mask",   "lock", "group",  "undo",  "redo",  "open"};
  std::string kind;
  // The kind is read first, so that messages can say it.
  JsonReader(json, where, problem).word("edit", kind, std::span(all).first(inside_group ? 9 : all.size()), Presence::required);
  ScriptEntry entry;
  if (!problem.empty()) return entry;
  const EntryReading at{where + " (" + kind + ")", problem};
  JsonReader reader(json, at.where, problem);
  reader.text("edit", kind);
  if (kind == "stroke") entry.what = read_stroke(reader, at);
  if (kind == "fill") entry.what = read_fill(reader, at);
  if (kind == "select") entry.what = read_select(reader);
  if (kind == "clear") read_layer(reader, "layer", entry.what.emplace<ClearEdit>().layer);
  if (kind == "image") entry.what = read_image(reader, at);
  if (kind == "mix") entry.what = read_mix(reader);
  if (kind == "set") read_parts(reader, entry.what.emplace<PartsPatch>(), at);
  if (kind == "mask") read_file_name(reader, "file", entry.what.emplace<MaskEntry>().file, Presence::optional);
  if (kind == "lock") entry.what = read_lock(reader);
  if (kind == "undo") entry.what = read_steps<UndoEntry>(reader);
  if (kind == "redo") entry.what = read_steps<RedoEntry>(reader);
  if (kind == "open") entry.what = read_open(reader, at);
  if (kind == "group") {
    GroupEntry group;
    reader.text("name", group.name);
    const Json* const list = reader.value("edits", Presence::required, "a list of edits");
    if (list && !list->is_array()) reader.refuse("edits", "a list of edits", *list);
    if (list && list->is_array()) group.entries = read_entries(*list, at.where, "part", true, problem);
    entry.what = std::move(group);
  }
  reader.finish();
  return entry;
}

std::vector<ScriptEntry> read_entries(const Json& list, const std::string& where, const char* what, bool inside_group,
                                      std::string& problem) {
  std::vector<ScriptEntry> entries;
  entries.reserve(list.size());
  for (std::size_t i = 0; i < list.size() && problem.empty(); ++i) {
    const std::string place = where + (inside_group ? ", " : ": ") + what + " " + std::to_string(i + 1);
    entries.push_back(read_entry(list[i], place, inside_group, problem));
  }
  return entries;
}

Status check_head(const Json& json, const std::string& label) {
  const auto format = json.is_object() ? json.find("format") : json.end();
  if (!json.is_object() || format == json.end() || *format != "biotope-edits") {
    return fail(label + ": is no edit script; it must begin with {\"format\": \"biotope-edits\", \"version\": 1.");
  }
  const auto version = json.find("version");
  if (version == json.end() || !version->is_number_integer() || version->get<double>() < 1) {
    return fail(label + ": \"version\" must be a whole number from 1 to " + std::to_string(edit_script_version) + ".");
  }
  if (version->get<double>() > edit_script_version) {
    return fail(label + ": was made by a newer Biotope (edit script version " + version->dump() + "; this one reads up to " +
                std::to_string(edit_script_version) + "). Update Biotope to play it.");
  }
  return {};
}

}  // namespace

Result<EditScript> parse_edit_script(std::string_view text, const std::string& label) {
  const auto json = parse_json(text, label);
  if (!json) return tl::unexpected(json.error());
  if (const Status head = check_head(*json, label); !head) return tl::unexpected(head.error());
  EditScript script;
  std::string problem;
  JsonReader reader(*json, label, problem);
  reader.value("format", Presence::required, "a text");
  reader.value("version", Presence::required, "a whole number");
  std::string description;
  reader.text("description", description);
  if (reader.value("terrain", Presence::optional, "an object {...}")) {
    JsonReader terrain = reader.nested("terrain", Presence::required);
    terrain.number("width", script.width, {2, largest_side}, Presence::required);
    terrain.number("height", script.height, {2, largest_side}, Presence::required);
    terrain.finish();
  }
  const Json* const list = reader.value("edits", Presence::required, "a list of edits");
  if (list && !list->is_array()) reader.refuse("edits", "a list of edits", *list);
  reader.finish();
  if (problem.empty() && list) script.entries = read_entries(*list, label, "edit", false, problem);
  if (!problem.empty()) return fail(problem);
  return script;
}

}  // namespace biotope
