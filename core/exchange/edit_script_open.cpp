#include "core/exchange/edit_script_open.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/gdal_support.hpp"
#include "core/exchange/open_input.hpp"

namespace biotope {
namespace {

using namespace script_json;

constexpr int largest_file_side = 1000000;  // cells of a file, of which a part may be taken

Json raw_to_json(const RawLayout& raw) {
  return {{"width", raw.width},
          {"height", raw.height},
          {"type", raw.sample_type},
          {"big_endian", raw.big_endian},
          {"header_bytes", raw.header_bytes}};
}

RawLayout read_raw(JsonReader& raw) {
  static const std::array<std::string, 7> types{"uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  RawLayout layout;
  raw.number("width", layout.width, {1, largest_file_side}, Presence::required);
  raw.number("height", layout.height, {1, largest_file_side}, Presence::required);
  raw.word("type", layout.sample_type, types, Presence::required);
  raw.boolean("big_endian", layout.big_endian);
  double header = 0;
  raw.number("header_bytes", header, {0, 1e12});
  layout.header_bytes = std::size_t(header);
  raw.finish();
  return layout;
}

Rect read_crop(JsonReader& crop) {
  int x = 0;
  int y = 0;
  int width = 1;
  int height = 1;
  crop.number("x", x, {0, largest_file_side}, Presence::required);
  crop.number("y", y, {0, largest_file_side}, Presence::required);
  crop.number("width", width, {1, largest_file_side}, Presence::required);
  crop.number("height", height, {1, largest_file_side}, Presence::required);
  crop.finish();
  return {x, y, x + width, y + height};
}

template <class T>
void read_if_there(JsonReader& reader, std::string_view key, std::optional<T>& target, Limits limits) {
  if (reader.value(key, Presence::optional, "a number") == nullptr) return;
  T value{};
  reader.number(key, value, limits);
  target = value;
}

/// The file and what belongs to it.
std::vector<std::filesystem::path> with_companions(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files{file};
  if (is_scene_file(file)) return files;
  register_gdal_drivers();
  const GdalErrorScope errors;
  const DatasetPointer dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset) return files;
  char** const list = dataset->GetFileList();
  for (char** name = list; name != nullptr && *name != nullptr; ++name) {
    const std::filesystem::path companion(*name);
    std::error_code error;
    if (companion != file && companion.parent_path() == file.parent_path() && std::filesystem::is_regular_file(companion, error))
      files.push_back(companion);
  }
  CSLDestroy(list);
  return files;
}

/// A stem that no file of that ending has in a folder: "alps", "alps-2" ...
std::string free_stem(const std::filesystem::path& file, const std::filesystem::path& target) {
  const std::string stem = file.stem().string();
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? stem : stem + "-" + std::to_string(number);
    std::error_code error;
    if (!std::filesystem::exists(target / (name + file.extension().string()), error)) return name;
  }
}

}  // namespace

namespace script_json {

void write_open(Json& json, const OpenEntry& entry) {
  if (entry.file.empty()) {
    json["sample"] = entry.sample;
  } else {
    json["file"] = entry.file;
  }
  const DemImportOptions& options = entry.options;
  if (options.cell_size) json["cell_size"] = *options.cell_size;
  if (options.longer_side) json["size"] = *options.longer_side;
  if (options.latitude) json["latitude"] = *options.latitude;
  if (options.vertical_scale != 1) json["vertical_scale"] = options.vertical_scale;
  if (options.vertical_offset != 0) json["vertical_offset"] = options.vertical_offset;
  if (options.voids == VoidHandling::keep_as_sea) json["voids"] = "sea";
  if (options.crop) {
    json["crop"] = {
        {"x", options.crop->x0}, {"y", options.crop->y0}, {"width", options.crop->width()}, {"height", options.crop->height()}};
  }
  if (options.raw) json["raw"] = raw_to_json(*options.raw);
}

OpenEntry read_open(JsonReader& reader, const EntryReading&) {
  static const std::array<std::string, 4> samples{"valley", "valley-1m", "alpine", "canyon"};
  static const std::array<std::string, 2> voids{"fill", "sea"};
  OpenEntry entry;
  read_file_name(reader, "file", entry.file, Presence::optional);
  if (entry.file.empty()) reader.word("sample", entry.sample, samples, Presence::required);
  DemImportOptions& options = entry.options;
  read_if_there(reader, "cell_size", options.cell_size, {0.001, 100000});
  read_if_there(reader, "size", options.longer_side, {2, 16384});
  read_if_there(reader, "latitude", options.latitude, {-90, 90});
  reader.number("vertical_scale", options.vertical_scale, {1e-6, 1e6});
  reader.number("vertical_offset", options.vertical_offset, {-12000, 12000});
  read_word(reader, "voids", voids, options.voids);
  if (reader.value("crop", Presence::optional, "an object {...}")) {
    JsonReader crop = reader.nested("crop", Presence::required);
    options.crop = read_crop(crop);
  }
  if (reader.value("raw", Presence::optional, "an object {...}")) {
    JsonReader raw = reader.nested("raw", Presence::required);
    options.raw = read_raw(raw);
  }
  return entry;
}

}  // namespace script_json

Result<Document> open_entry(const OpenEntry& entry, const std::filesystem::path& folder, const TaskContext& context) {
  if (entry.file.empty()) return open_input("sample:" + entry.sample, entry.options, context);
  const auto file = script_file(folder, entry.file);
  if (!file) return tl::unexpected(file.error());
  return open_input(file->string(), entry.options, context);
}

Result<std::string> bring_beside(const std::filesystem::path& file, const std::filesystem::path& folder,
                                 const std::string& inside) {
  std::error_code error;
  const auto real = std::filesystem::canonical(file, error);
  if (error) return fail(file.string() + ": is not there any more, and the script needs it.");
  const auto home = std::filesystem::canonical(folder.empty() ? std::filesystem::path(".") : folder, error);
  const std::filesystem::path relative = error ? std::filesystem::path() : real.lexically_relative(home);
  if (!relative.empty() && *relative.begin() != "..") return relative.generic_string();
  const std::filesystem::path target = home / inside;
  std::filesystem::create_directories(target, error);
  if (error) return fail(target.string() + ": the folder cannot be made (" + error.message() + ").");
  const std::string stem = free_stem(real, target);
  for (const std::filesystem::path& part : with_companions(real)) {
    const std::string own = part.filename().string();
    const std::string old_stem = real.stem().string();
    const std::string name = own.starts_with(old_stem) ? stem + own.substr(old_stem.size()) : own;
    std::filesystem::copy_file(part, target / name, std::filesystem::copy_options::overwrite_existing, error);
    if (error) return fail((target / name).string() + ": cannot be written (" + error.message() + ").");
  }
  return inside + "/" + stem + real.extension().string();
}

}  // namespace biotope
