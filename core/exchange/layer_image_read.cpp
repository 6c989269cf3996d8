#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/exchange/gdal_support.hpp"
#include "core/exchange/height_source.hpp"
#include "core/exchange/layer_image.hpp"

namespace biotope {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// Brightness of red, green and blue (Rec. 709).
constexpr std::array<float, 3> luminance{0.2126F, 0.7152F, 0.0722F};

/// An image as read: one band of grey or numbers, or three of colour; all on the image's own cells.
struct ImageBands {
  std::vector<Grid<float>> colours;
  /// How much of each pixel counts, 0..1.
  Grid<float> opacity;
  /// Whether colours are shades 0..1 rather than numbers with a meaning of their own.
  bool picture = false;
  /// The number that white had in the file.
  float white = 1;

  [[nodiscard]] int width() const { return opacity.width(); }
  [[nodiscard]] int height() const { return opacity.height(); }
  [[nodiscard]] float brightness(std::size_t i) const {
    if (colours.size() == 1) return colours[0][i];
    return luminance[0] * colours[0][i] + luminance[1] * colours[1][i] + luminance[2] * colours[2][i];
  }
};

class ImageReader {
 public:
  ImageReader(const std::filesystem::path& file, GDALDataset& dataset) : name_(file.string()), dataset_(dataset) {}

  Result<ImageBands> read() {
    const int bands = dataset_.GetRasterCount();
    const int width = dataset_.GetRasterXSize();
    const int height = dataset_.GetRasterYSize();
    if (bands == 0) return fail(name_ + ": holds no raster of its own (a collection of several data sets?).");
    if (bands > 4)
      return fail(name_ + ": has " + std::to_string(bands) + " bands; an image has 1 (grey) to 4 (colour and opacity).");
    if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
      return fail(name_ + ": " + std::to_string(width) + " x " + std::to_string(height) +
                  " pixels are too many; the longer side may have " + std::to_string(largest_side) + ".");
    }
    const GDALDataType type = dataset_.GetRasterBand(1)->GetRasterDataType();
    if (GDALDataTypeIsComplex(type)) return fail(name_ + ": holds complex numbers, which are no image.");
    image_.picture = type == GDT_Byte || type == GDT_UInt16;
    image_.white = type == GDT_UInt16 ? 65535.0F : type == GDT_Byte ? 255.0F : 1.0F;
    image_.opacity = Grid<float>(width, height, 1.0F);
    const auto* palette = dataset_.GetRasterBand(1)->GetColorTable();
    if (Status read = palette ? read_palette(*palette) : read_bands(bands); !read) {
      return tl::unexpected(read.error());
    }
    hide_missing();
    return std::move(image_);
  }

 private:
  Status read_band(int number, Grid<float>& cells) {
    const GdalErrorScope errors;
    cells = Grid<float>(image_.width(), image_.height());
    const CPLErr read =
        dataset_.GetRasterBand(number)->RasterIO(GF_Read, 0, 0, cells.width(), cells.height(), cells.cells().data(),
                                                 cells.width(), cells.height(), GDT_Float32, 0, 0, nullptr);
    if (read != CE_None || errors.failed()) return fail(name_ + ": is damaged or cut short" + because(errors) + ".");
    return {};
  }

  Status read_bands(int bands) {
    const bool has_opacity = bands == 2 || bands == 4;
    for (int band = 1; band <= bands; ++band) {
      const bool opacity = has_opacity && band == bands;
      Grid<float>& cells = opacity ? image_.opacity : image_.colours.emplace_back();
      if (Status read = read_band(band, cells); !read) return read;
      if (!opacity) hide_no_data(band, cells);
      for (float& cell : cells.cells()) cell /= image_.white;
    }
    return {};
  }

  /// A colour per number: the palette's entry.
  Status read_palette(const GDALColorTable& palette) {
    Grid<float> numbers;
    if (Status read = read_band(1, numbers); !read) return read;
    image_.colours.assign(3, Grid<float>(image_.width(), image_.height()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const GDALColorEntry* entry = palette.GetColorEntry(int(numbers[i]));
      if (entry == nullptr) return fail(name_ + ": a pixel has a colour that its palette does not hold.");
      image_.colours[0][i] = float(entry->c1) / 255;
      image_.colours[1][i] = float(entry->c2) / 255;
      image_.colours[2][i] = float(entry->c3) / 255;
      image_.opacity[i] = float(entry->c4) / 255;
    }
    image_.picture = true;
    return {};
  }

  void hide_no_data(int band, Grid<float>& cells) {
    int has_value = 0;
    const auto missing = float(dataset_.GetRasterBand(band)->GetNoDataValue(&has_value));
    if (has_value == 0) return;
    std::replace(cells.cells().begin(), cells.cells().end(), missing, nothing);
  }

  /// What is no number counts as nothing.
  void hide_missing() {
    for (Grid<float>& colour : image_.colours) {
      for (std::size_t i = 0; i < colour.size(); ++i) {
        if (std::isfinite(colour[i])) continue;
        colour[i] = 0;
        image_.opacity[i] = 0;
      }
    }
    for (float& opacity : image_.opacity.cells()) opacity = std::isfinite(opacity) ? std::clamp(opacity, 0.0F, 1.0F) : 0.0F;
  }

  std::string name_;
  GDALDataset& dataset_;
  ImageBands image_;
};

Result<ImageBands> read_image(const std::filesystem::path& file) {
  if (const Status readable = check_readable(file); !readable) return tl::unexpected(readable.error());
  const GdalErrorScope errors;
  const DatasetPointer dataset = open_raster(file);
  if (!dataset)
    return fail(file.string() + ": is not an image that can be read" + because(errors) + ". Give a PNG, TIFF or JPEG.");
  return ImageReader(file, *dataset).read();
}

/// Which pixels along one side make a cell, and with what weights.
struct Taps {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Taps> taps_along(int pixels, int cells) {
  std::vector<Taps> taps(std::size_t(cells), Taps{});
  const double ratio = double(pixels) / cells;
  for (int cell = 0; cell < cells; ++cell) {
    Taps& at = taps[std::size_t(cell)];
    // A cell finer than a pixel lies between the centres of two; a coarser one covers several.
    const double centre = (cell + 0.5) * ratio;
    const double reach = std::max(ratio, 1.0) / 2;
    const int from = std::max(0, int(std::floor(centre - reach)));
    const int to = std::min(pixels, int(std::ceil(centre + reach)));
    at.first = from;
    for (int pixel = from; pixel < to; ++pixel) {
      const double covered = std::min(centre + reach, pixel + 1.0) - std::max(centre - reach, double(pixel));
      at.weights.push_back(float(std::max(covered, 0.0)));
    }
  }
  return taps;
}

/// Brightness stretched over a terrain; NaN where most of the image counts for nothing.
Grid<float> stretched(const ImageBands& image, int width, int height) {
  const std::vector<Taps> columns = taps_along(image.width(), width);
  const std::vector<Taps> rows = taps_along(image.height(), height);
  Grid<float> values(width, height);
  parallel_rows(0, height, [&](int y) {
    const Taps& row = rows[std::size_t(y)];
    for (int x = 0; x < width; ++x) {
      const Taps& column = columns[std::size_t(x)];
      double sum = 0;
      double counted = 0;
      double all = 0;
      for (std::size_t j = 0; j < row.weights.size(); ++j) {
        for (std::size_t i = 0; i < column.weights.size(); ++i) {
          const std::size_t pixel = image.opacity.index(column.first + int(i), row.first + int(j));
          const double weight = double(row.weights[j]) * double(column.weights[i]);
          sum += weight * double(image.opacity[pixel]) * double(image.brightness(pixel));
          counted += weight * double(image.opacity[pixel]);
          all += weight;
        }
      }
      values(x, y) = counted * 2 < all || counted <= 0 ? nothing : float(sum / counted);
    }
  });
  return values;
}

/// Class of a colour: that of the nearest of geology_colours, or nothing where white is nearer.
float geology_of(const ImageBands& image, std::size_t pixel) {
  const auto distance = [&](const std::array<std::uint8_t, 3>& colour) {
    float sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float difference = image.colours[image.colours.size() == 1 ? 0 : c][pixel] * 255 - float(colour[c]);
      sum += difference * difference;
    }
    return sum;
  };
  float nearest = distance({255, 255, 255});
  float found = nothing;
  for (std::size_t rock = 0; rock < geology_colours.size(); ++rock) {
    const float here = distance(geology_colours[rock]);
    if (here >= nearest) continue;
    nearest = here;
    found = float(rock);
  }
  return found;
}

Result<Grid<float>> geology_classes_of(const ImageBands& image, const std::string& name, int width, int height) {
  Grid<float> classes(width, height, nothing);
  for (int y = 0; y < height; ++y) {
    const int row = std::min(image.height() - 1, int((y + 0.5) * image.height() / height));
    for (int x = 0; x < width; ++x) {
      const int column = std::min(image.width() - 1, int((x + 0.5) * image.width() / width));
      const std::size_t pixel = image.opacity.index(column, row);
      if (image.opacity[pixel] < 0.5F) continue;
      if (image.colours.size() > 1) {
        classes(x, y) = geology_of(image, pixel);
        continue;
      }
      const float number = image.colours[0][pixel] * image.white;
      const float rounded = std::round(number);
      if (rounded < 0 || rounded >= float(geology_classes)) {
        return fail(name + ": pixel " + std::to_string(column) + ", " + std::to_string(row) + " holds " + std::to_string(number) +
                    ", which is no geology class. A grey image holds class numbers 0 to " + std::to_string(geology_classes - 1) +
                    "; a colour image a colour for each class.");
      }
      classes(x, y) = rounded;
    }
  }
  return classes;
}

}  // namespace

std::optional<ValueRange> usual_range(const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::resource:
      return ValueRange{1, 9};
    case LayerKind::plant_density:
    case LayerKind::loss:
      return ValueRange{0, 1};
    case LayerKind::geology:
      return ValueRange{0, float(geology_classes - 1)};
    case LayerKind::passage:
      return ValueRange{-1, 1};
    case LayerKind::animal_density:
    case LayerKind::ground:
      return std::nullopt;
  }
  return std::nullopt;
}

Result<Grid<float>> read_layer_image(const std::filesystem::path& file, const LayerId& layer, const Terrain& terrain,
                                     const std::optional<ValueRange>& range) {
  const auto image = read_image(file);
  if (!image) return tl::unexpected(image.error());
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  if (layer.kind == LayerKind::geology) return geology_classes_of(*image, file.string(), width, height);
  if (image->picture && !range && !usual_range(layer)) {
    return fail(file.string() + ": is a picture, and the layer has no usual range: say which values black and white stand for.");
  }
  Grid<float> values = stretched(*image, width, height);
  if (!image->picture && !range) return values;
  const ValueRange to = range ? *range : *usual_range(layer);
  for (float& value : values.cells()) value = to.low + (to.high - to.low) * value;
  return values;
}

Result<Grid<float>> read_stamp(const std::filesystem::path& file) {
  const auto image = read_image(file);
  if (!image) return tl::unexpected(image.error());
  Grid<float> weights(image->width(), image->height());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = std::clamp(image->brightness(i) * image->opacity[i], 0.0F, 1.0F);
  }
  return weights;
}

}  // namespace biotope
