#include "core/exchange/scene_raster.hpp"

#include <cpl_vsi.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <map>
#include <memory>

#include "core/exchange/gdal_support.hpp"

namespace biotope {
namespace {

/// A name among GDAL's files in memory, whose file goes with its owner.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<unsigned> count{0};
    name_ = "/vsimem/biotope-" + std::to_string(count.fetch_add(1)) + ".tif";
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Shows `bytes` as the file's content without copying; they must outlive the file.
  void show(const std::string& bytes) const {
    auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
    VSIFCloseL(VSIFileFromMemBuffer(name_.c_str(), data, bytes.size(), FALSE));
  }
  [[nodiscard]] std::string content() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return data == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(data), std::size_t(size));
  }

 private:
  std::string name_;
};

struct TiffLayout {
  int bands = 1;
  GDALDataType type = GDT_Float32;
  bool sparse = false;
};

/// Side of a block, cells: a few tiles, which packs better than one.
constexpr int block_side = 256;
static_assert(block_side % tile_side == 0);

DatasetPointer create_tiff(const MemoryFile& file, int width, int height, const TiffLayout& layout) {
  register_gdal_drivers();
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", layout.type == GDT_Float32 ? "3" : "1");
  // Level 6 takes 4 % less room than level 1 and half as much time again, which is still not what a save waits for.
  options.SetNameValue("ZLEVEL", "6");
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("BLOCKXSIZE", std::to_string(block_side).c_str());
  options.SetNameValue("BLOCKYSIZE", std::to_string(block_side).c_str());
  options.SetNameValue("INTERLEAVE", "BAND");
  if (layout.sparse) options.SetNameValue("SPARSE_OK", "TRUE");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) return nullptr;
  return DatasetPointer(driver->Create(file.name().c_str(), width, height, layout.bands, layout.type, options.List()));
}

Result<std::string> finished(DatasetPointer dataset, const MemoryFile& file, const GdalErrorScope& errors) {
  if (dataset) dataset->FlushCache(true);
  dataset.reset();
  if (errors.failed()) return fail("A map of the scene cannot be packed" + because(errors) + ".");
  return file.content();
}

template <class T>
Result<std::string> encode_cells(const Grid<T>& cells, GDALDataType type, const Georeference* georeference) {
  const GdalErrorScope errors;
  const MemoryFile file;
  DatasetPointer dataset = create_tiff(file, cells.width(), cells.height(), {1, type, false});
  if (!dataset) return fail("A map of the scene cannot be packed" + because(errors) + ".");
  if (georeference != nullptr) {
    auto transform = georeference->transform;
    dataset->SetGeoTransform(transform.data());
    if (!georeference->wkt.empty()) dataset->SetProjection(georeference->wkt.c_str());
  }
  const CPLErr written =
      dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, cells.width(), cells.height(), const_cast<T*>(cells.cells().data()),
                                          cells.width(), cells.height(), type, 0, 0, nullptr);
  if (written != CE_None) return fail("A map of the scene cannot be packed" + because(errors) + ".");
  return finished(std::move(dataset), file, errors);
}

/// Blocks that a scene's maps are packed in are smaller; a file that claims larger ones would have them allocated.
constexpr int largest_block = 1024;
/// DEFLATE never packs better than 1 : 1032, and scenes leave no block of these maps out. A file that claims more cells than that
/// is damaged, and its cells are not allocated.
constexpr std::uint64_t best_packing = 1032;

tl::unexpected<Error> damaged(const std::string& what, const std::string& why) {
  return fail(what + ": is damaged (" + why + ").");
}

/// Opens a GeoTIFF in memory and checks that it is what the scene says it is.
Result<DatasetPointer> open_tiff(const MemoryFile& file, int width, int height, const TiffLayout& layout, const std::string& what,
                                 const GdalErrorScope& errors) {
  register_gdal_drivers();
  const char* const drivers[] = {"GTiff", nullptr};
  DatasetPointer dataset(GDALDataset::Open(file.name().c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) return damaged(what, "not a GeoTIFF" + because(errors));
  if (dataset->GetRasterXSize() != width || dataset->GetRasterYSize() != height) {
    return damaged(what, "its size is not the terrain's");
  }
  if (dataset->GetRasterCount() != layout.bands) return damaged(what, "not the bands expected");
  for (int band = 1; band <= layout.bands; ++band) {
    int block_width = 0;
    int block_height = 0;
    dataset->GetRasterBand(band)->GetBlockSize(&block_width, &block_height);
    if (dataset->GetRasterBand(band)->GetRasterDataType() != layout.type) return damaged(what, "not the samples expected");
    if (block_width > largest_block || block_height > largest_block) return damaged(what, "its blocks are too large");
  }
  return dataset;
}

template <class T>
Result<Grid<T>> decode_cells(const std::string& bytes, int width, int height, GDALDataType type, const std::string& what) {
  const GdalErrorScope errors;
  const MemoryFile file;
  file.show(bytes);
  const auto dataset = open_tiff(file, width, height, {1, type, false}, what, errors);
  if (!dataset) return tl::unexpected(dataset.error());
  const std::uint64_t unpacked = std::uint64_t(width) * std::uint64_t(height) * sizeof(T);
  if (unpacked > best_packing * bytes.size()) return damaged(what, "it is too short for its cells");
  Grid<T> cells(width, height);
  const CPLErr read = (*dataset)->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, width, height, cells.cells().data(), width, height,
                                                             type, 0, 0, nullptr);
  if (read != CE_None || errors.failed()) return damaged(what, "cells cannot be read" + because(errors));
  return cells;
}

using Tile = PaintLayer::Tile;
template <class T>
using Band = std::array<T, std::size_t(tile_side) * tile_side>;

template <class T>
CPLErr transfer_tile(GDALDataset& dataset, GDALRWFlag direction, int band, const Rect& rect, Band<T>& cells) {
  return dataset.GetRasterBand(band)->RasterIO(direction, rect.x0, rect.y0, rect.width(), rect.height(), cells.data(),
                                               rect.width(), rect.height(), sizeof(T) == 1 ? GDT_Byte : GDT_Float32, sizeof(T),
                                               GSpacing(sizeof(T)) * tile_side, nullptr);
}

/// Paint that can be read again: a cell that is no number is saved as unpainted rather than make the scene unreadable.
Paint readable(Paint paint) {
  if (!std::isfinite(paint.value) || std::isnan(paint.coverage)) return {};
  return {paint.value, std::clamp(paint.coverage, 0.0F, 1.0F)};
}

bool is_paint(const Paint& paint) { return std::isfinite(paint.value) && paint.coverage >= 0 && paint.coverage <= 1; }

/// Tiles that are one colour all over are shared, so that a small file cannot ask for much memory.
class PaintTiles {
 public:
  [[nodiscard]] PaintLayer::TilePointer tile_of(const Band<float>& value, const Band<float>& coverage) {
    auto tile = std::make_shared<Tile>();
    bool uniform = true;
    for (std::size_t cell = 0; cell < tile->size(); ++cell) {
      (*tile)[cell] = {value[cell], coverage[cell]};
      uniform = uniform && std::bit_cast<std::uint64_t>((*tile)[cell]) == std::bit_cast<std::uint64_t>(tile->front());
    }
    if (!uniform) return tile;
    if (tile->front() == Paint{}) return nullptr;
    auto& shared = uniform_[std::bit_cast<std::uint64_t>(tile->front())];
    if (!shared) shared = std::move(tile);
    return shared;
  }

 private:
  std::map<std::uint64_t, PaintLayer::TilePointer> uniform_;
};

}  // namespace

Result<std::string> encode_floats(const Grid<float>& cells, const Georeference& georeference) {
  return encode_cells(cells, GDT_Float32, &georeference);
}

Result<std::string> encode_bytes(const Grid<std::uint8_t>& cells) { return encode_cells(cells, GDT_Byte, nullptr); }

Result<std::string> encode_paint(const PaintLayer& layer) {
  assert(layer.background() == Paint{});
  const GdalErrorScope errors;
  const MemoryFile file;
  DatasetPointer dataset = create_tiff(file, layer.width(), layer.height(), {2, GDT_Float32, true});
  if (!dataset) return fail("A layer of the scene cannot be packed" + because(errors) + ".");
  Band<float> value;
  Band<float> coverage;
  for (std::size_t i = 0; i < layer.tile_count(); ++i) {
    const auto& tile = layer.tile(i);
    if (!tile) continue;
    for (std::size_t cell = 0; cell < tile->size(); ++cell) {
      const Paint paint = readable((*tile)[cell]);
      value[cell] = paint.value;
      coverage[cell] = paint.coverage;
    }
    const Rect rect = layer.tile_rect(i);
    if (transfer_tile(*dataset, GF_Write, 1, rect, value) != CE_None ||
        transfer_tile(*dataset, GF_Write, 2, rect, coverage) != CE_None) {
      return fail("A layer of the scene cannot be packed" + because(errors) + ".");
    }
  }
  return finished(std::move(dataset), file, errors);
}

Result<std::string> encode_selection(const SelectionMask& mask) {
  const GdalErrorScope errors;
  const MemoryFile file;
  DatasetPointer dataset = create_tiff(file, mask.width(), mask.height(), {1, GDT_Byte, true});
  if (!dataset) return fail("The selection cannot be packed" + because(errors) + ".");
  Band<std::uint8_t> cells;
  for (std::size_t i = 0; i < mask.tile_count(); ++i) {
    const auto& tile = mask.tile(i);
    if (!tile && mask.background() == 0) continue;
    if (tile) {
      cells = *tile;
    } else {
      cells.fill(mask.background());
    }
    if (transfer_tile(*dataset, GF_Write, 1, mask.tile_rect(i), cells) != CE_None) {
      return fail("The selection cannot be packed" + because(errors) + ".");
    }
  }
  return finished(std::move(dataset), file, errors);
}

Result<Grid<float>> decode_floats(const std::string& bytes, int width, int height, const std::string& what) {
  return decode_cells<float>(bytes, width, height, GDT_Float32, what);
}

Result<Grid<std::uint8_t>> decode_bytes(const std::string& bytes, int width, int height, const std::string& what) {
  return decode_cells<std::uint8_t>(bytes, width, height, GDT_Byte, what);
}

Result<PaintLayer> decode_paint(const std::string& bytes, int width, int height, const std::string& what) {
  const GdalErrorScope errors;
  const MemoryFile file;
  file.show(bytes);
  const auto dataset = open_tiff(file, width, height, {2, GDT_Float32, false}, what, errors);
  if (!dataset) return tl::unexpected(dataset.error());
  PaintLayer layer(width, height);
  PaintTiles tiles;
  for (std::size_t i = 0; i < layer.tile_count(); ++i) {
    const Rect rect = layer.tile_rect(i);
    Band<float> value{};
    Band<float> coverage{};
    if (transfer_tile(**dataset, GF_Read, 1, rect, value) != CE_None ||
        transfer_tile(**dataset, GF_Read, 2, rect, coverage) != CE_None) {
      return damaged(what, "cells cannot be read" + because(errors));
    }
    auto tile = tiles.tile_of(value, coverage);
    if (tile && !std::all_of(tile->begin(), tile->end(), is_paint)) {
      return damaged(what, "paint that is no number or covers more than all");
    }
    layer.set_tile(i, std::move(tile));
  }
  if (errors.failed()) return damaged(what, "cells cannot be read" + because(errors));
  return layer;
}

Result<SelectionMask> decode_selection(const std::string& bytes, int width, int height, const std::string& what) {
  const GdalErrorScope errors;
  const MemoryFile file;
  file.show(bytes);
  const auto dataset = open_tiff(file, width, height, {1, GDT_Byte, false}, what, errors);
  if (!dataset) return tl::unexpected(dataset.error());
  SelectionMask mask(width, height);
  for (std::size_t i = 0; i < mask.tile_count(); ++i) {
    Band<std::uint8_t> cells{};
    if (transfer_tile(**dataset, GF_Read, 1, mask.tile_rect(i), cells) != CE_None) {
      return damaged(what, "cells cannot be read" + because(errors));
    }
    if (cells != Band<std::uint8_t>{}) mask.set_tile(i, std::make_shared<const SelectionMask::Tile>(cells));
  }
  if (errors.failed()) return damaged(what, "cells cannot be read" + because(errors));
  return mask;
}

}  // namespace biotope
