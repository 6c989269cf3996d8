#include "core/climate/environment_state.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/climate/environment_layers.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {

Status IlluminationState::restart(const Terrain& terrain, const Derivatives& derivatives, const Climate& climate,
                                  const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  for (auto& layer : layers_) layer.restart(nullptr);
  context.report("illumination", 0);
  horizons_ = std::make_unique<HorizonField>(terrain);
  sunlight_ = std::make_unique<Sunlight>(terrain.latitude, width, horizons_->horizons());
  std::array<std::shared_ptr<Grid<float>>, 12> made;
  std::array<Grid<float>*, 12> out{};
  parallel_each(12, [&](std::size_t month) {
    made[month] = std::make_shared<Grid<float>>(Grid<float>::shareable(width, height));
    out[month] = made[month].get();
  });
  const TileSet all = TileSet::all(width, height);
  const int columns = (width + tile_side - 1) / tile_side;
  for (std::size_t first = 0; first < all.tile_count(); first += std::size_t(columns)) {
    if (context.stopped()) return fail("stopped");
    context.report("illumination", 0.1 + 0.9 * double(first) / double(all.tile_count()));
    parallel_each(std::size_t(columns), [&](std::size_t column) {
      const Rect rect = all.rect(first + column);
      sunlight_->illuminate(derivatives, horizons_->horizons(), rect, out);
      for (std::size_t month = 0; month < 12; ++month) irradiance_to_index(climate, month, rect, *out[month]);
    });
  }
  for (std::size_t month = 0; month < 12; ++month) layers_[month].restart(std::move(made[month]));
  changes_.note_all(width, height);
  stale_ = TileSet(width, height, small_side);
  stale_slopes_ = stale_;
  moved_ = MovedHorizons(width, height, horizons_->horizons().sectors.size());
  return {};
}

void IlluminationState::follow(const Terrain& terrain, const TileSet& heights, const TileSet& slopes) {
  if (heights.any()) {
    horizons_->update(terrain, heights, moved_);
    stale_ |= moved_.tiles();
  }
  stale_slopes_ |= slopes.in_tiles_of(small_side);
  stale_ |= stale_slopes_;
}

bool IlluminationState::remake(const Derivatives& derivatives, const Climate& climate, std::size_t tile,
                               const std::array<std::shared_ptr<Grid<float>>, 12>& made) const {
  const Rect cells = stale_.rect(tile);
  std::array<bool, 12> asked{};
  asked.fill(true);
  if (!stale_slopes_.contains(tile)) asked = sunlight_->changed_months(horizons_->horizons(), moved_, tile, cells);
  std::array<Grid<float>*, 12> out{};
  for (std::size_t month = 0; month < 12; ++month) out[month] = asked[month] ? made[month].get() : nullptr;
  if (std::ranges::count(asked, true) == 0) return false;
  sunlight_->illuminate(derivatives, horizons_->horizons(), cells, out);
  bool another = false;
  for (std::size_t month = 0; month < 12; ++month) {
    if (!asked[month]) continue;
    irradiance_to_index(climate, month, cells, *made[month]);
    another = another || !same_cells(*made[month], *layers_[month].newest(), cells);
  }
  return another;
}

void IlluminationState::update(const Derivatives& derivatives, const Climate& climate, const TileSet& tiles) {
  const TileSet asked = stale_ & tiles.in_tiles_of(small_side);
  if (!asked.any()) return;
  std::array<std::shared_ptr<Grid<float>>, 12> made;
  parallel_each(12, [&](std::size_t month) { made[month] = layers_[month].copy(); });
  const auto list = asked.list();
  std::vector<char> another(list.size(), 0);
  parallel_each(list.size(), [&](std::size_t i) { another[i] = remake(derivatives, climate, list[i], made) ? 1 : 0; });
  TileSet changed(asked.width(), asked.height(), small_side);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (another[i] != 0) changed.insert(list[i]);
    moved_.forget(list[i]);
  }
  for (std::size_t month = 0; month < 12; ++month) layers_[month].put(std::move(made[month]), changed);
  if (changed.any()) changes_.note(changed);
  stale_ -= asked;
  stale_slopes_ -= asked;
}

MonthlyMap IlluminationState::map() const {
  MonthlyMap map;
  for (const auto& layer : layers_) map.layers.push_back(layer.newest());
  return map;
}

void IlluminationState::release_unused() {
  for (auto& layer : layers_) layer.release_unused();
}

void TemperatureState::restart(const Terrain& terrain, const Climate& climate) {
  auto layer = std::make_shared<Grid<float>>(Grid<float>::shareable(terrain.height.width(), terrain.height.height()));
  parallel_rows(0, layer->height(), [&](int y) {
    temperature_of_heights(terrain, climate, {0, y, layer->width(), y + 1}, *layer);
  });
  changes_.note_all(layer->width(), layer->height());
  layer_.restart(std::move(layer));
}

void TemperatureState::update(const Terrain& terrain, const Climate& climate, const TileSet& tiles) {
  const TileSet changed = remake_tiles(layer_, tiles.in_tiles_of(small_side), [&](const Rect& rect, Grid<float>& out) {
    temperature_of_heights(terrain, climate, rect, out);
  });
  if (changed.any()) changes_.note(changed);
}

MonthlyMap TemperatureState::map(const Climate& climate) const { return {{layer_.newest()}, temperature_offsets(climate)}; }

}  // namespace biotope
