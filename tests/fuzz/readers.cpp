#include "tests/fuzz/readers.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/climate/climate.hpp"
#include "core/exchange/edit_script.hpp"
#include "core/exchange/placements_json.hpp"
#include "core/exchange/scene_file.hpp"
#include "core/exchange/scene_json.hpp"
#include "core/exchange/scene_raster.hpp"
#include "core/species/species_library.hpp"

namespace biotope_test {
namespace {

using namespace biotope;

constexpr const char* origin = "file";

void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", law);
  std::abort();
}

/// Every Error says where.
template <class Value>
bool taken(const Result<Value>& result) {
  require(result || result.error().message.find(origin) != std::string::npos, "a message names its file");
  return result.has_value();
}

/// What is written is read again and written the same.
template <class Parse, class Write>
void read_text(std::string_view text, const Parse& parse, const Write& write) {
  const auto first = parse(text);
  if (!taken(first)) return;
  const std::string once = write(*first);
  const auto again = parse(once);
  if (!again) std::fprintf(stderr, "%s\n%s\n", again.error().message.c_str(), once.c_str());
  require(again.has_value(), "what was written can be read");
  require(write(*again) == once, "what was read is written the same");
}

void read_species(std::string_view text) {
  read_text(text, [](std::string_view json) { return parse_species(json, origin); }, species_to_json);
  auto species = parse_species(text, origin);
  if (species) static_cast<void>(build_food_web(std::move(*species)));
}

void read_climate(std::string_view text) {
  read_text(text, [](std::string_view json) { return parse_climate(json, origin); }, climate_to_json);
}

void read_placements(std::string_view text) {
  read_text(text, [](std::string_view json) { return parse_placements_text(json, origin); },
            [](const Placements& placements) { return placements_to_json(placements).dump(); });
}

void read_edit_script(std::string_view text) {
  read_text(text, [](std::string_view json) { return parse_edit_script(json, origin); }, edit_script_to_json);
}

void read_manifest(std::string_view text) {
  read_text(text, [](std::string_view json) { return parse_manifest(std::string(json), origin); }, manifest_to_json);
}

/// The first byte says as what the rest is read.
void read_raster(std::string_view bytes) {
  if (bytes.empty()) return;
  constexpr int width = 100;
  constexpr int height = 70;
  const std::string rest(bytes.substr(1));
  switch (bytes.front() % 4) {
    case 0:
      if (const auto paint = decode_paint(rest, width, height, origin); taken(paint)) {
        const auto packed = encode_paint(*paint);
        require(packed.has_value(), "what was read can be packed");
        const auto again = decode_paint(*packed, width, height, origin);
        require(again && *again == *paint, "paint is the same after packing");
      }
      break;
    case 1:
      static_cast<void>(taken(decode_floats(rest, width, height, origin)));
      break;
    case 2:
      static_cast<void>(taken(decode_bytes(rest, width, height, origin)));
      break;
    default:
      static_cast<void>(taken(decode_selection(rest, width, height, origin)));
      break;
  }
}

void read_scene(std::string_view bytes) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / (std::string(origin) + "-fuzzed-" + std::to_string(::getpid()) + ".biotope");
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  const auto scene = load_scene(file);
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (!taken(scene)) return;
  require(scene->terrain && scene->species, "a scene has a terrain and species");
}

const std::vector<FuzzedReader>& all_readers() {
  static const std::vector<FuzzedReader> readers{{"scene", read_scene},           {"manifest", read_manifest}, {"raster", read_raster},
                                                 {"species", read_species},       {"climate", read_climate},   {"placements", read_placements},
                                                 {"edit-script", read_edit_script}};
  return readers;
}

}  // namespace

std::span<const FuzzedReader> fuzzed_readers() { return all_readers(); }

}  // namespace biotope_test
