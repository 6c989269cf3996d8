#include "render/ground_picture.hpp"

#include <algorithm>
#include <utility>

#include "core/base/parallel.hpp"
#include "render/changed_tiles.hpp"
#include "render/terrain_shadow.hpp"
#include "render/water_flow.hpp"

namespace biotope {

namespace {

/// Longest side of a ground texture, texels.
constexpr int longest_texture = 2048;
/// Longest side of the texture of shores and trails where it is finer than the terrain: finer costs a software renderer too long.
constexpr int longest_lines = 2048;
/// Longest side of the grid on which shadows are swept, cells.
constexpr int longest_shadow = 1024;
/// Longest side of the texture of currents, texels.
constexpr int longest_currents = 1024;

int stride_for(const Grid<float>& grid, int longest) {
  const int wanted = (std::max(grid.width(), grid.height()) + longest - 1) / longest;
  // A long and narrow grid keeps at least one row.
  return std::clamp(wanted, 1, std::max(1, std::min(grid.width(), grid.height())));
}

/// How finely a picture is made: the surface of every `surface`-th cell, a texel for every `texel`-th of those.
struct Strides {
  int surface = 1;
  int texel = 1;
  [[nodiscard]] int cells_a_texel() const { return surface * texel; }
};

template <class Texel>
const TiledMap<Texel>* finest(const TexelPyramid<Texel>* before) {
  return before != nullptr && !before->levels.empty() ? &before->levels.front() : nullptr;
}

/// A map as a texture with all its mipmaps.
template <class Texel>
TexelPyramid<Texel> with_mipmaps(TiledMap<Texel> texels, const TexelPyramid<Texel>* before) {
  TexelPyramid<Texel> out;
  out.levels.push_back(std::move(texels));
  add_mipmaps(out, before);
  return out;
}

/// The tile of a map that covers `rect`, from the texels of that rect.
template <class Texel>
std::shared_ptr<typename TiledMap<Texel>::Tile> tile_of(const Grid<Texel>& texels, const Rect& rect) {
  auto tile = std::make_shared<typename TiledMap<Texel>::Tile>();
  for (int y = 0; y < texels.height(); ++y) {
    std::copy_n(texels.row(y).data(), texels.width(), tile->data() + TiledMap<Texel>::offset(rect.x0, rect.y0 + y));
  }
  return tile;
}

/// Normals: only tiles near which heights have changed are made again.
TiledMap<Rgba> normals_of(const Grid<float>& shown, double cell_size, const TiledMap<float>& heights, const GroundShape* before) {
  TiledMap<Rgba> out(shown.width(), shown.height());
  const bool comparable = before != nullptr && before->normals.levels.front().rect() == out.rect();
  parallel_each(out.tile_count(), [&](std::size_t i) {
    const Rect rect = out.tile_rect(i);
    const bool same = comparable && same_tiles(heights, before->heights.levels.front(), grown(rect, normal_reach));
    out.set_tile(i, same ? before->normals.levels.front().tile(i) : tile_of(surface_normals(shown, cell_size, rect), rect));
  });
  return out;
}

std::shared_ptr<const GroundShape> make_shape(const MapsSnapshot& snapshot, const Strides& strides, const GroundShape* before) {
  auto shape = std::make_shared<GroundShape>();
  shape->surface = visible_surface(snapshot, strides.surface);
  const double cell_size = snapshot.terrain().cell_size * strides.surface;
  shape->bounds = HeightBounds(shape->surface, cell_size, ground_patch_cells);
  const Grid<float> thin = strides.texel > 1 ? thinned(shape->surface, strides.texel) : Grid<float>();
  const Grid<float>& shown = strides.texel > 1 ? thin : shape->surface;
  shape->heights.levels.push_back(shared_tiles(shown, before != nullptr ? finest(&before->heights) : nullptr));
  shape->normals = with_mipmaps(normals_of(shown, cell_size * strides.texel, shape->heights.levels.front(), before),
                                before != nullptr ? &before->normals : nullptr);
  shape->shading = thinned(shape->surface, stride_for(shape->surface, longest_shadow));
  return shape;
}

/// True when two pictures' colours can only differ by the plants' cover.
bool same_but_cover(const GroundRequest& a, const GroundRequest& b) {
  return a.month == b.month && a.visible == b.visible && a.snapshot->surface() == b.snapshot->surface() &&
         a.snapshot->hydrology == b.snapshot->hydrology && a.snapshot->environment == b.snapshot->environment &&
         a.snapshot->derivatives == b.snapshot->derivatives && a.snapshot->web == b.snapshot->web &&
         a.snapshot->cover.size() == b.snapshot->cover.size();
}

std::shared_ptr<const GroundTints> make_tints(const GroundRequest& request, int stride, const GroundPicture* before) {
  const Grid<float>& height = request.snapshot->terrain().height;
  const GroundTints* old = before != nullptr && same_but_cover(request, before->of) ? before->tints.get() : nullptr;
  const Grid<std::uint8_t> changed =
      old != nullptr ? changed_cover(*request.snapshot, *before->of.snapshot) : Grid<std::uint8_t>();
  if (old != nullptr && std::none_of(changed.cells().begin(), changed.cells().end(), [](std::uint8_t c) { return c != 0; })) {
    return before->tints;
  }
  const auto is_stale = [&](const Rect& texels) {
    if (old == nullptr) return true;
    for (int y = texels.y0 * stride / tile_side; y * tile_side < std::min(texels.y1 * stride, height.height()); ++y) {
      for (int x = texels.x0 * stride / tile_side; x * tile_side < std::min(texels.x1 * stride, height.width()); ++x) {
        if (changed(x, y) != 0) return true;
      }
    }
    return false;
  };
  TiledMap<Rgba> ground(height.width() / stride, height.height() / stride);
  TiledMap<Rgba> canopy(ground.width(), ground.height());
  parallel_each(ground.tile_count(), [&](std::size_t i) {
    const Rect rect = ground.tile_rect(i);
    if (!is_stale(rect)) {
      ground.set_tile(i, old->ground.levels.front().tile(i));
      canopy.set_tile(i, old->canopy.levels.front().tile(i));
      return;
    }
    const GroundColours colours = colour_ground(*request.snapshot, request.month, request.visible, stride, rect);
    ground.set_tile(i, tile_of(colours.ground, rect));
    canopy.set_tile(i, tile_of(colours.canopy, rect));
  });
  auto tints = std::make_shared<GroundTints>();
  tints->ground = with_mipmaps(std::move(ground), old != nullptr ? &old->ground : nullptr);
  tints->canopy = with_mipmaps(std::move(canopy), old != nullptr ? &old->canopy : nullptr);
  return tints;
}

/// Squares of ground_patch_cells cells, all dry.
Grid<std::uint8_t> dry_squares(const Terrain& terrain) {
  return Grid<std::uint8_t>((terrain.height.width() + ground_patch_cells - 1) / ground_patch_cells,
                            (terrain.height.height() + ground_patch_cells - 1) / ground_patch_cells, 0);
}

Grid<std::uint8_t> wet_squares(const Terrain& terrain, const ShoreMap& shore) {
  Grid<std::uint8_t> squares = dry_squares(terrain);
  parallel_rows(0, squares.height(), [&](int row) {
    const int south = terrain.height.height() - row * ground_patch_cells;
    const int y0 = std::max(0, south - ground_patch_cells) * shore.scale;
    for (int y = y0; y < south * shore.scale; ++y) {
      const auto codes = shore.codes.row(y);
      for (std::size_t x = 0; x < codes.size(); ++x) {
        if (codes[x] > 0) squares(int(x) / shore.scale / ground_patch_cells, row) = 1;
      }
    }
  });
  return squares;
}

/// How water moves; still where there is none.
TexelPyramid<Rgba> currents_of(const Terrain& terrain, const Hydrology* hydrology, const FordLook& fords) {
  TexelPyramid<Rgba> out;
  const Grid<Rgba> still(1, 1, Rgba{128, 128, 0, 0});
  out.levels.push_back(shared_tiles<Rgba>(
      hydrology != nullptr ? water_flow(terrain, *hydrology, stride_for(terrain.height, longest_currents), fords) : still,
      nullptr));
  return out;
}

/// True when a person placed the same fords in both.
bool same_fords(const Places* a, const Places* b) {
  const std::vector<PlacedFord> none;
  return a == b || (a != nullptr ? a->fords : none) == (b != nullptr ? b->fords : none);
}

/// What is alike in two snapshots, so that lines drawn for one are good for the other.
struct Alike {
  bool ground = false;
  bool water = false;
  bool trails = false;
};

void draw_water_lines(const MapsSnapshot& snapshot, const GroundLines* before, const Alike& alike, GroundLines& out) {
  const Terrain& terrain = snapshot.terrain();
  const FordLook fords(snapshot.ground());
  // Where water is drawn does not depend on the ground's height, how it moves does.
  if (before != nullptr && alike.water) {
    out.shore = before->shore;
    out.near_water = before->near_water;
  } else {
    const int scale = line_field_scale(terrain.height.width(), terrain.height.height(), longest_lines);
    out.shore = std::make_shared<const ShoreMap>(ShoreMap{
        scale, snapshot.hydrology ? shore_field(terrain, *snapshot.hydrology, scale, fords)
                                  : Grid<std::uint8_t>(terrain.height.width() * scale, terrain.height.height() * scale, 0)});
    out.near_water = wet_squares(terrain, *out.shore);
  }
  out.currents =
      before != nullptr && alike.water && alike.ground ? before->currents : currents_of(terrain, snapshot.hydrology.get(), fords);
}

std::shared_ptr<const GroundLines> make_lines(const MapsSnapshot& snapshot, const GroundLines* before, const Alike& alike) {
  const Terrain& terrain = snapshot.terrain();
  auto out = std::make_shared<GroundLines>();
  draw_water_lines(snapshot, before, alike, *out);
  if (before != nullptr && alike.water && alike.trails) {
    out->lines = before->lines;
    out->trails = before->trails;
    return out;
  }
  const Grid<std::uint8_t>& shore = out->shore->codes;
  const int scale = out->shore->scale;
  const Grid<std::uint8_t> wear =
      snapshot.trails ? wear_field(terrain, *snapshot.trails, scale) : Grid<std::uint8_t>(shore.width(), shore.height(), 0);
  Grid<Rg> lines(shore.width(), shore.height());
  parallel_rows(0, lines.height(), [&](int y) {
    for (int x = 0; x < lines.width(); ++x) lines(x, y) = {shore(x, y), wear(x, y)};
  });
  out->lines = with_mipmaps(shared_tiles(lines, before != nullptr ? finest(&before->lines) : nullptr),
                            before != nullptr ? &before->lines : nullptr);
  if (before != nullptr && alike.trails) {
    out->trails = before->trails;
  } else if (snapshot.trails) {
    out->trails = std::make_shared<const TrailLines>(terrain, *snapshot.trails, soft_edge(terrain, scale));
  }
  return out;
}

std::shared_ptr<const GroundLight> make_light(const GroundRequest& request, const GroundShape& shape) {
  const double cell = request.snapshot->terrain().width_metres() / shape.shading.width();
  auto out = std::make_shared<GroundLight>();
  out->light = request.light;
  out->sunlit.levels.push_back(
      shared_tiles<std::uint8_t>(sweep_shadows(shape.shading, cell, request.light, 1.0F + 0.35F * float(cell)), nullptr));
  return out;
}

}  // namespace

bool same_light(const glm::vec3& a, const glm::vec3& b) { return a == b || glm::dot(a, b) >= 0.99998F; }

bool same_request(const GroundRequest& a, const GroundRequest& b) {
  return a.snapshot == b.snapshot && a.month == b.month && a.visible == b.visible && same_light(a.light, b.light);
}

bool same_extent(const Terrain& a, const Terrain& b) { return a.height.rect() == b.height.rect() && a.cell_size == b.cell_size; }

std::shared_ptr<const GroundPicture> make_ground(const GroundRequest& request, const GroundPicture* before,
                                                 const std::stop_token& stop) {
  const MapsSnapshot& snapshot = *request.snapshot;
  if (before != nullptr && (before->coarse || !same_extent(before->terrain(), snapshot.terrain()))) before = nullptr;
  const MapsSnapshot* then = before != nullptr ? before->of.snapshot.get() : nullptr;
  const Strides strides{1, stride_for(snapshot.terrain().height, longest_texture)};
  Alike alike;
  if (then != nullptr) {
    const bool water = then->hydrology == snapshot.hydrology && same_fords(then->places.get(), snapshot.places.get());
    alike = {then->surface() == snapshot.surface(), water, then->trails == snapshot.trails};
  }
  const bool same_form = alike.ground && alike.water && alike.trails;
  auto picture = std::make_shared<GroundPicture>();
  picture->of = request;
  picture->shape = same_form ? before->shape : make_shape(snapshot, strides, before != nullptr ? before->shape.get() : nullptr);
  if (stop.stop_requested()) return nullptr;
  picture->lines = same_form ? before->lines : make_lines(snapshot, before != nullptr ? before->lines.get() : nullptr, alike);
  if (stop.stop_requested()) return nullptr;
  picture->tints = make_tints(request, strides.cells_a_texel(), before);
  if (stop.stop_requested()) return nullptr;
  const bool same_shadows = same_form && same_light(before->light->light, request.light);
  picture->light = same_shadows ? before->light : make_light(request, *picture->shape);
  return picture;
}

std::shared_ptr<const GroundPicture> make_coarse_ground(const GroundRequest& request) {
  const Terrain& terrain = request.snapshot->terrain();
  const Strides strides{stride_for(terrain.height, coarse_ground_side), 1};
  auto picture = std::make_shared<GroundPicture>();
  picture->of = request;
  picture->coarse = true;
  picture->shape = make_shape(*request.snapshot, strides, nullptr);
  auto lines = std::make_shared<GroundLines>();
  lines->near_water = dry_squares(terrain);
  lines->lines.levels.push_back(shared_tiles<Rg>(Grid<Rg>(1, 1), nullptr));
  lines->currents = currents_of(terrain, nullptr, {});
  picture->lines = std::move(lines);
  picture->tints = make_tints(request, strides.cells_a_texel(), nullptr);
  picture->light = make_light(request, *picture->shape);
  return picture;
}

}  // namespace biotope
