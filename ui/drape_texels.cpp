#include "ui/drape_texels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/parallel.hpp"
#include "render/map_colours.hpp"

namespace biotope {
namespace {

constexpr int most_texels = 2048;  // a side
constexpr glm::vec3 film_colour{0.77F, 0.16F, 0.24F};
constexpr glm::vec3 locked_colour{0.30F, 0.36F, 0.47F};
constexpr glm::vec3 stripe_colour{0.82F, 0.86F, 0.92F};
constexpr float film_opacity = 0.55F;
constexpr float locked_opacity = 0.5F;
constexpr int stripe = 8;  // texels from one stripe to the next

/// Colour and cover, not premultiplied.
struct Ink {
  glm::vec3 colour{0};
  float cover = 0;
};

Ink over(const Ink& below, const glm::vec3& colour, float cover) {
  if (cover <= 0) return below;
  const float left = below.cover * (1 - cover);
  const float sum = cover + left;
  return {(colour * cover + below.colour * left) / sum, sum};
}

/// A map's colours, looked up once.
class Palette {
 public:
  explicit Palette(const MapOverlay& overlay) : overlay_(overlay), table_(colour_table()) {}

  [[nodiscard]] Ink ink(float value) const {
    if (std::isnan(value) || value <= overlay_.clear_below) return {};
    if (overlay_.colours == ColourMap::categorical) {
      const auto colour = category_colour(int(std::lround(value)));
      return {{colour[0], colour[1], colour[2]}, overlay_.opacity};
    }
    const float span = std::max(overlay_.high - overlay_.low, 1e-9F);
    const float t = std::clamp((value - overlay_.low) / span, 0.0F, 1.0F);
    float soft = 1;
    if (!std::isnan(overlay_.clear_below)) soft = std::clamp((value - overlay_.clear_below) / span / 0.06F, 0.0F, 1.0F);
    const std::size_t entry =
        (std::size_t(overlay_.colours) * colour_table_width + std::size_t(t * float(colour_table_width - 1) + 0.5F)) * 4;
    const auto part = [&](std::size_t channel) { return float(table_[entry + channel]) / 255; };
    return {{part(0), part(1), part(2)}, overlay_.opacity * soft};
  }

 private:
  const MapOverlay& overlay_;
  std::vector<std::uint8_t> table_;
};

Rgba packed(const Ink& ink) {
  const auto byte = [&](float value) { return std::uint8_t(std::lround(std::clamp(value, 0.0F, 1.0F) * 255)); };
  return {byte(ink.colour.x * ink.cover), byte(ink.colour.y * ink.cover), byte(ink.colour.z * ink.cover), byte(ink.cover)};
}

bool same_maps(const FilterMaps& a, const FilterMaps& b) {
  return a.slope == b.slope && a.altitude == b.altitude && a.aspect == b.aspect && a.water_distance == b.water_distance &&
         a.values == b.values;
}

bool same_overlay(const MapOverlay& a, const MapOverlay& b) {
  const bool same_clear = a.clear_below == b.clear_below || (std::isnan(a.clear_below) && std::isnan(b.clear_below));
  return same_clear && a.cells == b.cells && a.low == b.low && a.high == b.high && a.colours == b.colours &&
         a.opacity == b.opacity;
}

bool same_film(const DrapeSource::Film& a, const DrapeSource::Film& b) {
  return a.filter == b.filter && a.selection == b.selection && same_maps(a.maps, b.maps);
}

template <class T, class Same>
bool same_optional(const std::optional<T>& a, const std::optional<T>& b, const Same& same) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

}  // namespace

bool same_drape(const DrapeSource& a, const DrapeSource& b) {
  return a.locked_area == b.locked_area && same_optional(a.overlay, b.overlay, same_overlay) &&
         same_optional(a.film, b.film, same_film);
}

int drape_step(int width, int height) { return std::max(1, (std::max(width, height) + most_texels - 1) / most_texels); }

void colour_drape(const DrapeSource& source, int step, const Rect& cells, Grid<Rgba>& texels) {
  const std::optional<Palette> palette = source.overlay ? std::optional<Palette>(*source.overlay) : std::nullopt;
  std::optional<CellFilter> filter;
  if (source.film) filter.emplace(source.film->filter, &source.film->maps, source.film->selection.get());
  const Rect rect =
      intersection(texels.rect(), {cells.x0 / step, cells.y0 / step, (cells.x1 + step - 1) / step, (cells.y1 + step - 1) / step});
  parallel_rows(rect.y0, rect.y1, [&](int row) {
    for (int column = rect.x0; column < rect.x1; ++column) {
      const int x = column * step;
      const int y = row * step;
      Ink ink;
      if (palette && source.overlay->cells->contains(x, y)) ink = palette->ink((*source.overlay->cells)(x, y));
      if (source.locked_area) {
        const bool striped = (column + row) % stripe < 2;
        ink = over(ink, striped ? stripe_colour : locked_colour, locked_opacity * locked_share(source.locked_area.get(), x, y));
      }
      if (filter) ink = over(ink, film_colour, film_opacity * (1 - (*filter)(x, y)));
      texels(column, row) = packed(ink);
    }
  });
}

}  // namespace biotope
