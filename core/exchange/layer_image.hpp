#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/climate/environment.hpp"
#include "core/document/document.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Values that black and white of a picture stand for, in a layer's unit.
struct ValueRange {
  float low = 0;
  float high = 1;
  bool operator==(const ValueRange&) const = default;
};

/// The range a layer's values usually have; nothing for animals and the ground, which have no natural upper end.
[[nodiscard]] std::optional<ValueRange> usual_range(const LayerId& layer);

/// Colours of the geology classes in pictures, red, green and blue, in the order of Geology. Our choice.
inline constexpr std::array<std::array<std::uint8_t, 3>, geology_classes> geology_colours{{
    {0xd9, 0xd2, 0xc0},  // limestone: pale stone
    {0x3b, 0x6e, 0xa5},  // water: blue
    {0x9a, 0x8f, 0x6b},  // marl: olive brown
    {0x6e, 0x6e, 0x6e},  // scree: grey
    {0x8c, 0x5a, 0x3c},  // alluvium: earth brown
}};

/// Reads any raster GDAL reads as values of a layer, stretched over the terrain: area means where the image is finer than the
/// terrain, linear in between where it is coarser; a georeference of its own is not looked at.
///   pictures (8 or 16 bits, unsigned): brightness 0..1 becomes low..high of `range`, which is usual_range where none is given;
///   other numbers: taken as they are, in the layer's unit; with a `range`, 0..1 becomes low..high;
///   geology: pictures in geology_colours (the nearest one), or class numbers; cells take the image's nearest pixel.
/// Cells are NaN where most of the image is transparent, has no data, or (geology) is white. An Error names the file.
[[nodiscard]] Result<Grid<float>> read_layer_image(const std::filesystem::path& file, const LayerId& layer,
                                                   const Terrain& terrain, const std::optional<ValueRange>& range = std::nullopt);

/// What an image is like before it is read.
struct ImageFacts {
  int width = 0;  ///< pixels
  int height = 0;
  bool picture = false;  ///< shades (8 or 16 bits, unsigned) rather than numbers
  float white = 255;     ///< the number of the brightest shade
  bool grey = true;      ///< no colours
};
/// Looks at an image's head. An Error names the file.
[[nodiscard]] Result<ImageFacts> look_at_image(const std::filesystem::path& file);

/// Reads a brush stamp: brightness 0..1 times opacity, on the image's own cells. Numbers of a floating-point raster are weights
/// 0..1.
[[nodiscard]] Result<Grid<float>> read_stamp(const std::filesystem::path& file);

/// Writes paint as a GeoTIFF of two bands, value and coverage, with the terrain's georeference. Atomic.
[[nodiscard]] Status write_paint_geotiff(const std::filesystem::path& file, const PaintLayer& paint, const Terrain& terrain);

/// Writes a map as a 16-bit grey PNG, low..high of `range` (by default the map's own least and greatest value) as 0..65535; what
/// is NaN is transparent. A world file (`.pgw`) beside it holds the terrain's georeference. Returns the range.
[[nodiscard]] Result<ValueRange> write_map_png(const std::filesystem::path& file, const Grid<float>& map, const Terrain& terrain,
                                               const std::optional<ValueRange>& range = std::nullopt);

/// The same of paint: value as grey, coverage as opacity.
[[nodiscard]] Result<ValueRange> write_paint_png(const std::filesystem::path& file, const PaintLayer& paint,
                                                 const Terrain& terrain, const std::optional<ValueRange>& range = std::nullopt);

/// Writes a map of geology classes as a PNG in geology_colours, with a world file.
[[nodiscard]] Status write_geology_png(const std::filesystem::path& file, const Grid<float>& classes, const Terrain& terrain);

}  // namespace biotope
