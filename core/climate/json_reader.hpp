#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/status.hpp"

namespace biotope {

/// JSON whose objects keep the order in which their keys were written.
using Json = nlohmann::ordered_json;

/// Smallest and largest value a number may have; both are allowed.
struct Limits {
  double low;
  double high;
};

/// Whether a key must be there; an optional one leaves its target at the default.
enum class Presence { required, optional };

/// A float as the shortest decimal that reads back as the same float: 0.2, not 0.20000000298.
[[nodiscard]] inline Json tidy_number(float value) {
  std::array<char, 48> text{};
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double decimal = 0;
  std::from_chars(text.data(), end, decimal);
  return decimal;
}

/// A text as it can stand in a message: cut where it is long, between two characters of UTF-8.
[[nodiscard]] inline std::string clipped(std::string_view text, std::size_t most = 60) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "...";
}

/// Number of single-character insertions, deletions and replacements between two words (Levenshtein).
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// "; did you mean "x"?" with the word nearest to `word`, or nothing when none is near.
[[nodiscard]] inline std::string nearest_word_hint(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t longest_word = 60;
  if (word.size() > longest_word) return {};
  std::size_t best = std::max<std::size_t>(2, word.size() / 3) + 1;
  std::string_view nearest;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest.empty() ? std::string{} : "; did you mean \"" + std::string(nearest) + "\"?";
}

/// Reads one JSON object key by key and checks every value. The first problem is kept in a string that nested readers share; it
/// says where (a file and what is described there), which key and what was expected. `finish` refuses keys nobody asked for.
class JsonReader {
 public:
  /// `where` begins every message; `prefix` is put before keys of nested objects, such as "shape.".
  JsonReader(const Json& object, std::string where, std::string& problem, std::string prefix = {})
      : object_(object), where_(std::move(where)), problem_(problem), prefix_(std::move(prefix)) {
    if (!object_.is_object()) note(where_ + ": expected an object {...}, got " + shown(object_));
  }

  [[nodiscard]] bool ok() const { return problem_.empty(); }

  /// The value of a key, or null when it is absent; notes a missing required key.
  const Json* value(std::string_view key, Presence presence, std::string_view expected) {
    known_.emplace_back(key);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(std::string(key));
    if (found != object_.end()) return &*found;
    if (presence == Presence::required) note(where_ + ": " + quoted(key) + " is missing; it must be " + std::string(expected));
    return nullptr;
  }

  /// Notes that `key` holds something else than `expected`.
  void refuse(std::string_view key, std::string_view expected, const Json& got) {
    note(where_ + ": " + quoted(key) + " must be " + std::string(expected) + ", got " + shown(got));
  }

  template <class Number>
  void number(std::string_view key, Number& target, Limits limits, Presence presence = Presence::optional) {
    constexpr bool whole = std::is_integral_v<Number>;
    const std::string expected = (whole ? "a whole number in " : "a number in ") + shown(limits);
    const Json* const found = value(key, presence, expected);
    if (!found) return;
    const bool right_type = whole ? found->is_number_integer() : found->is_number();
    if (!right_type || !within(*found, limits)) return refuse(key, expected, *found);
    target = found->get<Number>();
  }

  /// A fixed number of numbers, each within limits.
  template <class Number, std::size_t count>
  void numbers(std::string_view key, std::array<Number, count>& target, Limits limits, Presence presence = Presence::optional) {
    const std::string expected = std::to_string(count) + " numbers in " + shown(limits);
    const Json* const found = value(key, presence, expected);
    if (!found) return;
    if (!found->is_array() || found->size() != count || !all_within(*found, limits)) return refuse(key, expected, *found);
    for (std::size_t i = 0; i < count; ++i) target[i] = (*found)[i].template get<Number>();
  }

  /// Two numbers, the first not above the second.
  template <class Number>
  void range(std::string_view key, Number& low, Number& high, Limits limits, Presence presence = Presence::optional) {
    constexpr bool whole = std::is_integral_v<Number>;
    const std::string expected = std::string(whole ? "two whole numbers" : "two numbers") + " low <= high in " + shown(limits);
    const Json* const found = value(key, presence, expected);
    if (!found) return;
    if (!found->is_array() || found->size() != 2 || !all_within(*found, limits)) return refuse(key, expected, *found);
    const bool right_type = !whole || ((*found)[0].is_number_integer() && (*found)[1].is_number_integer());
    if (!right_type || (*found)[0].get<double>() > (*found)[1].get<double>()) return refuse(key, expected, *found);
    low = (*found)[0].get<Number>();
    high = (*found)[1].get<Number>();
  }

  void boolean(std::string_view key, bool& target, Presence presence = Presence::optional) {
    const Json* const found = value(key, presence, "true or false");
    if (!found) return;
    if (!found->is_boolean()) return refuse(key, "true or false", *found);
    target = found->get<bool>();
  }

  void text(std::string_view key, std::string& target, Presence presence = Presence::optional) {
    const Json* const found = value(key, presence, "a text");
    if (!found) return;
    if (!found->is_string() || found->get_ref<const std::string&>().empty()) return refuse(key, "a text", *found);
    target = found->get<std::string>();
  }

  /// One of a list of words.
  void word(std::string_view key, std::string& target, std::span<const std::string> words,
            Presence presence = Presence::optional) {
    std::string expected = "one of";
    for (const std::string& allowed : words) expected += (&allowed == words.data() ? " \"" : ", \"") + allowed + "\"";
    const Json* const found = value(key, presence, expected);
    if (!found) return;
    if (!found->is_string() || std::ranges::find(words, found->get<std::string>()) == words.end()) {
      return refuse(key, expected, *found);
    }
    target = found->get<std::string>();
  }

  /// Texts or numbers by any key.
  template <class Value>
  void dictionary(std::string_view key, std::map<std::string, Value>& target, Limits limits = {0, 0}) {
    constexpr bool is_text = std::is_same_v<Value, std::string>;
    const std::string each = is_text ? "a text" : "a number in " + shown(limits);
    const Json* const found = value(key, Presence::optional, "an object");
    if (!found) return;
    if (!found->is_object()) return refuse(key, "an object whose values are each " + each, *found);
    for (const auto& [name, entry] : found->items()) {
      const bool right = is_text ? entry.is_string() : (entry.is_number() && within(entry, limits));
      if (!right) return refuse(std::string(key) + "." + name, each, entry);
      target[name] = entry.template get<Value>();
    }
  }

  /// A reader of an object within this one, or of an empty object when the key is absent. Messages put "key." before its keys,
  /// unless they are `unprefixed`.
  [[nodiscard]] JsonReader nested(std::string_view key, Presence presence, bool unprefixed = false) {
    static const Json empty = Json::object();
    const Json* found = value(key, presence, "an object {...}");
    if (found && !found->is_object()) {
      refuse(key, "an object {...}", *found);
      found = nullptr;
    }
    return {found ? *found : empty, where_, problem_, unprefixed ? prefix_ : prefix_ + std::string(key) + "."};
  }

  /// Refuses keys that were never asked for, with a hint to the nearest one.
  void finish() {
    if (!ok() || !object_.is_object()) return;
    for (const auto& [key, unused] : object_.items()) {
      if (std::ranges::find(known_, key) != known_.end()) continue;
      return note(where_ + ": unknown key " + quoted(key) + nearest_word_hint(key, known_));
    }
  }

  /// A value as one short line of JSON, with a space after the commas of a list.
  [[nodiscard]] static std::string shown(const Json& value) {
    std::string line;
    if (value.is_array()) {
      constexpr std::size_t enough = 60;
      for (const Json& item : value) {
        if (line.size() > enough) break;
        line += (line.empty() ? "[" : ", ") + shown(item);
      }
      line = line.empty() ? "[]" : line + "]";
    } else {
      line = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return clipped(line);
  }
  [[nodiscard]] static std::string shown(Limits limits) {
    std::ostringstream stream;
    stream << limits.low << ".." << limits.high;
    return stream.str();
  }

 private:
  void note(std::string message) {
    if (problem_.empty()) problem_ = std::move(message);
  }
  [[nodiscard]] std::string quoted(std::string_view key) const { return "\"" + prefix_ + clipped(key) + "\""; }
  [[nodiscard]] static bool within(const Json& number, Limits limits) {
    const double value = number.get<double>();
    return value >= limits.low && value <= limits.high;
  }
  [[nodiscard]] static bool all_within(const Json& array, Limits limits) {
    return std::ranges::all_of(array, [&](const Json& item) { return item.is_number() && within(item, limits); });
  }

  const Json& object_;
  std::string where_;
  std::string& problem_;
  std::string prefix_;
  std::vector<std::string> known_;
};

/// More than any file of ours has: objects and lists within each other, keys in one object, values in all. A file beyond is
/// damage or a trap, and is refused before it takes time and memory. Our choice.
inline constexpr int deepest_json = 32;
inline constexpr std::size_t most_json_keys = 10000;
inline constexpr std::size_t most_json_values = 4'000'000;

/// Watches JSON while it is parsed: counts, and keeps the first key that is written twice in one object.
class JsonWatch {
 public:
  /// Throws std::length_error, whose text says what is too much.
  void see(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (depth > deepest_json) throw std::length_error("is nested more than " + std::to_string(deepest_json) + " deep");
    if (++values_ > most_json_values) throw std::length_error("holds more than " + std::to_string(most_json_values) + " values");
    if (event == Event::object_start) open_objects_.emplace_back();
    if (event == Event::object_end) open_objects_.pop_back();
    if (event == Event::key) see_key(parsed.get_ref<const std::string&>());
  }
  [[nodiscard]] const std::string& repeated() const { return repeated_; }

 private:
  void see_key(const std::string& key) {
    std::set<std::string>& keys = open_objects_.back();
    if (!keys.insert(key).second && repeated_.empty()) repeated_ = key;
    if (keys.size() > most_json_keys)
      throw std::length_error("has an object of more than " + std::to_string(most_json_keys) + " keys");
  }

  std::vector<std::set<std::string>> open_objects_;
  std::size_t values_ = 0;
  std::string repeated_;
};

/// JSON from text. Broken syntax is an Error that names `origin`, line and column; a key written twice in one object is one too,
/// since one of the two values would be lost without a word.
[[nodiscard]] inline Result<Json> parse_json(std::string_view text, std::string_view origin) {
  JsonWatch watch;
  const auto see = [&](int depth, Json::parse_event_t event, Json& parsed) {
    watch.see(depth, event, parsed);
    return true;
  };
  try {
    Json json = Json::parse(text.begin(), text.end(), see);
    if (!watch.repeated().empty()) {
      return fail(std::string(origin) + ": key \"" + clipped(watch.repeated()) + "\" is written twice in one object");
    }
    return json;
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0));
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t line_start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return fail(std::string(origin) + ":" + std::to_string(line) + ":" + std::to_string(before.size() - line_start + 1) +
                ": not valid JSON; look for a missing comma, quote or bracket here");
  } catch (const Json::out_of_range&) {
    return fail(std::string(origin) + ": a number is too large to be read");
  } catch (const std::length_error& error) {
    return fail(std::string(origin) + ": " + error.what() + ", more than such a file can have");
  }
}

/// The whole of a text file; an Error that names the file when it cannot be read.
template <class Path>
[[nodiscard]] Result<std::string> read_text_file(const Path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail(file.string() + ": cannot be opened; check that it exists and may be read");
  // A folder opens as a file does, but has nothing to read.
  if (stream.peek() == std::ifstream::traits_type::eof() && !stream.eof())
    return fail(file.string() + ": is not a file that can be read");
  stream.clear();
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) return fail(file.string() + ": reading failed before the end of the file");
  return text;
}

}  // namespace biotope
