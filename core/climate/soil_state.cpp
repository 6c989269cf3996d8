#include <utility>

#include "core/base/parallel.hpp"
#include "core/climate/diffusion.hpp"
#include "core/climate/environment_layers.hpp"
#include "core/climate/environment_state.hpp"
#include "core/climate/soil_parts.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {
namespace {

/// What follows from spread water in some cells. Soil reads the moisture before it is limited to what soil can hold.
struct SoilCells {
  Grid<float>& moisture;
  Grid<float>& texture;
  Grid<Geology>& geology;

  void make(const SoilInput& input, const Grid<float>& spread, const Climate& climate, const Rect& cells) const {
    moisture_of_water(input.hydrology, spread, cells, moisture);
    soil_of_cells(input, cells, texture, geology);
    limit_moisture(geology, climate, cells, moisture);
  }
};

}  // namespace

Status SoilState::restart(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                          const Climate& climate, const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  moisture_.restart(nullptr);
  water_ = Grid<float>(width, height);
  conductance_ = Grid<float>(width, height);
  parallel_rows(0, height, [&](int y) {
    wet_cells(terrain, derivatives, hydrology, {0, y, width, y + 1}, water_, conductance_);
  });
  spread_ = copy_of(water_);
  for (int step = 0; step < spread_steps; ++step) {
    if (context.stopped()) return fail("stopped");
    context.report("moisture", double(step + 1) / (spread_steps + 1));
    diffuse(spread_, conductance_);
  }
  context.report("soil", 0);
  hollow_ = hollows(terrain);
  auto moisture = std::make_shared<Grid<float>>(Grid<float>::shareable(width, height));
  auto texture = std::make_shared<Grid<float>>(Grid<float>::shareable(width, height));
  auto geology = std::make_shared<Grid<Geology>>(Grid<Geology>::shareable(width, height));
  const SoilInput input{derivatives, hydrology, hollow_, *moisture};
  parallel_rows(0, height, [&](int y) {
    SoilCells{*moisture, *texture, *geology}.make(input, spread_, climate, {0, y, width, y + 1});
  });
  moisture_.restart(std::move(moisture));
  texture_.restart(std::move(texture));
  geology_.restart(std::move(geology));
  changes_.note_all(width, height);
  return {};
}

void SoilState::update(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Climate& climate,
                       const SoilChange& change) {
  TileSet asked = change.slopes | change.water;
  if (asked.any()) {
    parallel_each(asked.list().size(), [&, list = asked.list()](std::size_t i) {
      wet_cells(terrain, derivatives, hydrology, asked.rect(list[i]), water_, conductance_);
    });
    Grid<float> spread = copy_of(water_);
    for (int step = 0; step < spread_steps; ++step) diffuse(spread, conductance_);
    asked |= differing_tiles_of(spread, spread_);
    spread_ = std::move(spread);
  }
  if (change.heights.any()) {
    Grid<float> hollow = hollows(terrain);
    asked |= differing_tiles_of(hollow, hollow_);
    hollow_ = std::move(hollow);
  }
  if (!asked.any()) return;
  const auto moisture_before = moisture_.newest();
  const auto texture_before = texture_.newest();
  const auto geology_before = geology_.newest();
  auto moisture = moisture_.copy();
  auto texture = texture_.copy();
  auto geology = geology_.copy();
  const SoilInput input{derivatives, hydrology, hollow_, *moisture};
  const TileSet changed = changed_tiles(asked.in_tiles_of(small_side), [&](const Rect& rect) {
    SoilCells{*moisture, *texture, *geology}.make(input, spread_, climate, rect);
    return !same_cells(*moisture, *moisture_before, rect) || !same_cells(*texture, *texture_before, rect) ||
           !same_cells(*geology, *geology_before, rect);
  });
  moisture_.put(std::move(moisture), changed);
  texture_.put(std::move(texture), changed);
  geology_.put(std::move(geology), changed);
  if (changed.any()) changes_.note(changed);
}

MonthlyMap SoilState::moisture(const Climate& climate) const { return {{moisture_.newest()}, moisture_offsets(climate)}; }

void SoilState::release_unused() {
  moisture_.release_unused();
  texture_.release_unused();
  geology_.release_unused();
}

}  // namespace biotope
