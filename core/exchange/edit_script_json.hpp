#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/climate/json_reader.hpp"
#include "core/exchange/edit_script.hpp"

// Pieces of edit scripts as JSON, shared by the reader and the writer.

namespace biotope::script_json {

// The words of a script, in the order of the enumerations they stand for.
[[nodiscard]] std::span<const std::string> layer_kind_words();
[[nodiscard]] std::span<const std::string> brush_mode_words();
[[nodiscard]] std::span<const std::string> falloff_words();
[[nodiscard]] std::span<const std::string> quantity_words();
[[nodiscard]] std::span<const std::string> shape_words();
[[nodiscard]] std::span<const std::string> selection_mode_words();
[[nodiscard]] std::span<const std::string> mix_words();
[[nodiscard]] std::span<const std::string> lock_words();

/// What reading an entry needs: where it stands and the first problem found.
struct EntryReading {
  std::string where;
  std::string& problem;
};

/// Reads one of `words` into the enumeration they stand for.
template <class Enum>
void read_word(JsonReader& reader, std::string_view key, std::span<const std::string> words, Enum& target,
               Presence presence = Presence::optional) {
  std::string word;
  reader.word(key, word, words, presence);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) target = Enum(found - words.begin());
}

void read_layer(JsonReader& reader, std::string_view key, LayerId& layer);
void read_point(JsonReader& reader, std::string_view key, PathPoint& point);
/// A file beside the script: a relative name that stays in the script's folder.
void read_file_name(JsonReader& reader, std::string_view key, std::string& file, Presence presence);

[[nodiscard]] Json brush_to_json(const Brush& brush, const std::string& stamp);
void read_brush(JsonReader& entry, Brush& brush, std::string& stamp, const EntryReading& at);
[[nodiscard]] Json filter_to_json(const BrushFilter& filter);
/// Reads the key "filter" of an entry or a brush.
void read_filter(JsonReader& holder, BrushFilter& filter, const EntryReading& at);
[[nodiscard]] Json condition_to_json(const FilterCondition& condition);
void read_condition(JsonReader& reader, FilterCondition& condition);
[[nodiscard]] Json point_to_json(PathPoint point);

/// The keys of a "set" entry.
void write_parts(Json& entry, const PartsPatch& patch);
void read_parts(JsonReader& entry, PartsPatch& patch, const EntryReading& at);

/// Numbers in scripts: positions in cells and values in any layer's unit. Beyond these a number is damage. Our choice.
inline constexpr Limits position_limits{-1e6, 1e6};
inline constexpr Limits value_limits{-1e9, 1e9};

}  // namespace biotope::script_json
