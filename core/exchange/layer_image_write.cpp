#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/gdal_support.hpp"
#include "core/exchange/layer_image.hpp"

namespace biotope {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// Samples of an image, band after band.
template <class Sample>
struct Samples {
  int width = 0;
  int height = 0;
  int bands = 1;
  std::vector<Sample> values;

  Samples(int w, int h, int count)
      : width(w), height(h), bands(count), values(std::size_t(w) * std::size_t(h) * std::size_t(count)) {}
  Sample& at(int band, std::size_t cell) { return values[std::size_t(band) * std::size_t(width) * std::size_t(height) + cell]; }
};

constexpr GDALDataType type_of(const Samples<std::uint8_t>&) { return GDT_Byte; }
constexpr GDALDataType type_of(const Samples<std::uint16_t>&) { return GDT_UInt16; }
constexpr GDALDataType type_of(const Samples<float>&) { return GDT_Float32; }

tl::unexpected<Error> unwritable(const std::filesystem::path& file, const GdalErrorScope& errors) {
  return fail(file.string() + ": cannot be written" + because(errors) +
              ". Is the folder there and writable, and is there space on the disk?");
}

template <class Sample>
CPLErr put(GDALDataset& dataset, Samples<Sample>& samples) {
  return dataset.RasterIO(GF_Write, 0, 0, samples.width, samples.height, samples.values.data(), samples.width, samples.height,
                          type_of(samples), samples.bands, nullptr, 0, 0, 0, nullptr);
}

/// The affine transform of the cells' centres, one number a line (a world file).
Status write_world_file(std::filesystem::path file, const Terrain& terrain) {
  const auto& t = terrain.georeference.transform;
  char text[256];
  std::snprintf(text, sizeof text, "%.15g\n%.15g\n%.15g\n%.15g\n%.15g\n%.15g\n", t[1], t[4], t[2], t[5], t[0] + (t[1] + t[2]) / 2,
                t[3] + (t[4] + t[5]) / 2);
  return write_text(file.replace_extension(".pgw"), text);
}

template <class Sample>
Status write_png(const std::filesystem::path& file, Samples<Sample>& samples, const Terrain& terrain) {
  register_gdal_drivers();
  const GdalErrorScope errors;
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
  if (memory == nullptr || png == nullptr) return fail(file.string() + ": GDAL has no PNG driver.");
  const DatasetPointer source(memory->Create("", samples.width, samples.height, samples.bands, type_of(samples), nullptr));
  if (!source || put(*source, samples) != CE_None) return unwritable(file, errors);
  if (samples.bands == 2 || samples.bands == 4) source->GetRasterBand(samples.bands)->SetColorInterpretation(GCI_AlphaBand);
  AtomicFile target(file);
  DatasetPointer copy(png->CreateCopy(target.temporary().c_str(), source.get(), FALSE, nullptr, nullptr, nullptr));
  if (!copy) return unwritable(file, errors);
  copy.reset();
  if (errors.failed()) return unwritable(file, errors);
  if (Status placed = target.commit(); !placed) return placed;
  return write_world_file(file, terrain);
}

/// Grey and opacity of 16 bits from values and how much of each counts.
template <class Value, class Opacity>
Samples<std::uint16_t> grey_samples(int width, int height, const ValueRange& range, const Value& value, const Opacity& opacity) {
  Samples<std::uint16_t> samples(width, height, 2);
  const float span = range.high > range.low ? range.high - range.low : 1.0F;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t cell = std::size_t(y) * std::size_t(width) + std::size_t(x);
      const float counts = opacity(x, y);
      samples.at(1, cell) = std::uint16_t(std::lround(std::clamp(counts, 0.0F, 1.0F) * 65535));
      if (counts > 0)
        samples.at(0, cell) = std::uint16_t(std::lround(std::clamp((value(x, y) - range.low) / span, 0.0F, 1.0F) * 65535));
    }
  }
  return samples;
}

/// Least and greatest of the values that count.
template <class Value>
ValueRange range_of(int width, int height, const Value& value) {
  ValueRange range{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float here = value(x, y);
      if (std::isnan(here)) continue;
      range.low = std::min(range.low, here);
      range.high = std::max(range.high, here);
    }
  }
  return range.low <= range.high ? range : ValueRange{};
}

}  // namespace

Status write_paint_geotiff(const std::filesystem::path& file, const PaintLayer& paint, const Terrain& terrain) {
  register_gdal_drivers();
  const GdalErrorScope errors;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) return fail(file.string() + ": GDAL has no GeoTIFF driver.");
  Samples<float> samples(paint.width(), paint.height(), 2);
  for (int y = 0; y < paint.height(); ++y) {
    for (int x = 0; x < paint.width(); ++x) {
      const std::size_t cell = std::size_t(y) * std::size_t(paint.width()) + std::size_t(x);
      const Paint here = paint(x, y);
      samples.at(0, cell) = here.value;
      samples.at(1, cell) = here.coverage;
    }
  }
  CPLStringList options;
  for (const char* option : {"COMPRESS=DEFLATE", "PREDICTOR=3", "ZLEVEL=1", "TILED=YES", "INTERLEAVE=BAND"})
    options.AddString(option);
  AtomicFile target(file);
  DatasetPointer dataset(
      driver->Create(target.temporary().c_str(), samples.width, samples.height, 2, GDT_Float32, options.List()));
  if (!dataset) return unwritable(file, errors);
  auto transform = terrain.georeference.transform;
  dataset->SetGeoTransform(transform.data());
  if (!terrain.georeference.wkt.empty()) dataset->SetProjection(terrain.georeference.wkt.c_str());
  dataset->GetRasterBand(1)->SetDescription("value");
  dataset->GetRasterBand(2)->SetDescription("coverage");
  const CPLErr written = put(*dataset, samples);
  dataset->FlushCache(true);
  dataset.reset();
  if (written != CE_None || errors.failed()) return unwritable(file, errors);
  return target.commit();
}

Result<ValueRange> write_map_png(const std::filesystem::path& file, const Grid<float>& map, const Terrain& terrain,
                                 const std::optional<ValueRange>& range) {
  const ValueRange from = range ? *range : range_of(map.width(), map.height(), map);
  auto samples =
      grey_samples(map.width(), map.height(), from, map, [&](int x, int y) { return std::isnan(map(x, y)) ? 0.0F : 1.0F; });
  if (Status written = write_png(file, samples, terrain); !written) return tl::unexpected(written.error());
  return from;
}

Result<ValueRange> write_paint_png(const std::filesystem::path& file, const PaintLayer& paint, const Terrain& terrain,
                                   const std::optional<ValueRange>& range) {
  const auto value = [&](int x, int y) { return paint(x, y).coverage > 0 ? paint(x, y).value : nothing; };
  const ValueRange from = range ? *range : range_of(paint.width(), paint.height(), value);
  auto samples = grey_samples(paint.width(), paint.height(), from, value, [&](int x, int y) { return paint(x, y).coverage; });
  if (Status written = write_png(file, samples, terrain); !written) return tl::unexpected(written.error());
  return from;
}

Status write_geology_png(const std::filesystem::path& file, const Grid<float>& classes, const Terrain& terrain) {
  Samples<std::uint8_t> samples(classes.width(), classes.height(), 4);
  for (std::size_t cell = 0; cell < classes.size(); ++cell) {
    const float rock = std::round(classes[cell]);
    if (!(rock >= 0 && rock < float(geology_classes))) continue;
    for (int c = 0; c < 3; ++c) samples.at(c, cell) = geology_colours[std::size_t(rock)][std::size_t(c)];
    samples.at(3, cell) = 255;
  }
  return write_png(file, samples, terrain);
}

}  // namespace biotope
