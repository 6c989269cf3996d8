#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <map>
#include <span>

#include "core/exchange/height_source.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {
namespace {

enum class RawType { uint8, int16, uint16, int32, uint32, float32, float64 };
struct RawTypeInfo {
  RawType type;
  std::size_t bytes;
};

const std::map<std::string, RawTypeInfo>& raw_types() {
  static const std::map<std::string, RawTypeInfo> types{
      {"uint8", {RawType::uint8, 1}},     {"int16", {RawType::int16, 2}},     {"uint16", {RawType::uint16, 2}},
      {"int32", {RawType::int32, 4}},     {"uint32", {RawType::uint32, 4}},   {"float32", {RawType::float32, 4}},
      {"float64", {RawType::float64, 8}}};
  return types;
}

template <class T>
void convert(std::span<char> bytes, bool swap, std::span<float> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    char* sample = bytes.data() + i * sizeof(T);
    if (swap) std::reverse(sample, sample + sizeof(T));
    T value;
    std::memcpy(&value, sample, sizeof(T));
    out[i] = float(value);
  }
}

void convert_row(RawType type, std::span<char> bytes, bool swap, std::span<float> out) {
  switch (type) {
    case RawType::uint8: convert<std::uint8_t>(bytes, swap, out); break;
    case RawType::int16: convert<std::int16_t>(bytes, swap, out); break;
    case RawType::uint16: convert<std::uint16_t>(bytes, swap, out); break;
    case RawType::int32: convert<std::int32_t>(bytes, swap, out); break;
    case RawType::uint32: convert<std::uint32_t>(bytes, swap, out); break;
    case RawType::float32: convert<float>(bytes, swap, out); break;
    case RawType::float64: convert<double>(bytes, swap, out); break;
  }
}

Result<RawTypeInfo> type_of(const std::filesystem::path& file, const RawLayout& layout) {
  const auto found = raw_types().find(layout.sample_type);
  if (found != raw_types().end()) return found->second;
  std::string names;
  for (const auto& [name, info] : raw_types()) names += (names.empty() ? "" : ", ") + name;
  return fail(file.string() + ": unknown sample type '" + layout.sample_type + "'; expected one of " + names + ".");
}

Status check_size(const std::filesystem::path& file, const RawLayout& layout, std::size_t sample_bytes) {
  std::error_code error;
  const std::uintmax_t actual = std::filesystem::file_size(file, error);
  const std::uintmax_t expected =
      layout.header_bytes + std::uintmax_t(layout.width) * std::uintmax_t(layout.height) * sample_bytes;
  if (!error && actual == expected) return {};
  return fail(file.string() + ": has " + std::to_string(actual) + " bytes, but " + std::to_string(layout.width) +
              " x " + std::to_string(layout.height) + " samples of " + layout.sample_type + " take " +
              std::to_string(expected) + ". Check the size and type given for RAW.");
}

}  // namespace

Result<HeightSource> read_raw_heights(const std::filesystem::path& file, const DemImportOptions& options,
                                      const TaskContext& context) {
  const RawLayout& layout = *options.raw;
  const auto type = type_of(file, layout);
  if (!type) return tl::unexpected(type.error());
  const auto crop = crop_of(file, options, layout.width, layout.height);
  if (!crop) return tl::unexpected(crop.error());
  if (const Status size = check_size(file, layout, type->bytes); !size) return tl::unexpected(size.error());

  HeightSource source;
  source.format = "RAW";
  source.sample_type = layout.sample_type;
  source.file_width = layout.width;
  source.file_height = layout.height;
  source.height = Grid<float>(crop->width(), crop->height());
  const bool swap = layout.big_endian != (std::endian::native == std::endian::big);
  const HeightScale scale{options.vertical_scale, options.vertical_offset};
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> bytes(std::size_t(crop->width()) * type->bytes);
  for (int y = 0; y < crop->height(); ++y) {
    if (context.stopped()) return fail(stopped_message);
    context.report("reading heights", double(y) / crop->height());
    const std::uintmax_t cell = std::uintmax_t(crop->y0 + y) * std::uintmax_t(layout.width) + std::uintmax_t(crop->x0);
    stream.seekg(std::streamoff(layout.header_bytes + cell * type->bytes));
    if (!stream.read(bytes.data(), std::streamsize(bytes.size()))) {
      return fail(file.string() + ": row " + std::to_string(crop->y0 + y) + " cannot be read.");
    }
    convert_row(type->type, bytes, swap, source.height.row(y));
    source.absurd_cells += scale_heights(source.height.row(y), scale, std::nullopt);
  }
  return source;
}

}  // namespace biotope
