#include <utility>

#include "core/base/parallel.hpp"
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

SoilState::SoilState() : spread_(spread_steps) {}

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
  const auto go_on = [&](int step) {
    context.report("moisture", double(step + 1) / (spread_steps + 1));
    return !context.stopped();
  };
  if (!spread_.restart(water_, {&conductance_}, go_on)) return fail("stopped");
  context.report("soil", 0);
  const Conductance even{nullptr, surroundings_conductance(terrain)};
  if (!surroundings_.restart(terrain.height, even, [&](int) { return !context.stopped(); })) return fail("stopped");
  auto moisture = std::make_shared<Grid<float>>(Grid<float>::shareable(width, height));
  auto texture = std::make_shared<Grid<float>>(Grid<float>::shareable(width, height));
  auto geology = std::make_shared<Grid<Geology>>(Grid<Geology>::shareable(width, height));
  const SoilInput input{derivatives, hydrology, terrain.height, surroundings_.result(), *moisture};
  parallel_rows(0, height, [&](int y) {
    SoilCells{*moisture, *texture, *geology}.make(input, spread_.result(), climate, {0, y, width, y + 1});
  });
  moisture_.restart(std::move(moisture));
  texture_.restart(std::move(texture));
  geology_.restart(std::move(geology));
  changes_.note_all(width, height);
  return {};
}

void SoilState::update(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Climate& climate,
                       const SoilChange& change) {
  const Conductance even{nullptr, surroundings_conductance(terrain)};
  TileSet asked = change.slopes | change.water;
  const bool follows = spread_.started();
  if (!follows) asked = TileSet::all(terrain.height.width(), terrain.height.height());
  if (asked.any()) {
    parallel_each(asked.list().size(), [&, list = asked.list()](std::size_t i) {
      wet_cells(terrain, derivatives, hydrology, asked.rect(list[i]), water_, conductance_);
    });
    if (follows) asked |= spread_.follow(water_, {&conductance_}, asked);
  }
  if (!follows) {
    const auto go_on = [](int) { return true; };
    spread_.restart(water_, {&conductance_}, go_on);
    surroundings_.restart(terrain.height, even, go_on);
  } else if (change.heights.any()) {
    asked |= change.heights | surroundings_.follow(terrain.height, even, change.heights);
  }
  if (!asked.any()) return;
  const auto moisture_before = moisture_.newest();
  const auto texture_before = texture_.newest();
  const auto geology_before = geology_.newest();
  auto moisture = moisture_.copy();
  auto texture = texture_.copy();
  auto geology = geology_.copy();
  const SoilInput input{derivatives, hydrology, terrain.height, surroundings_.result(), *moisture};
  const TileSet changed = changed_tiles(asked.in_tiles_of(small_side), [&](const Rect& rect) {
    SoilCells{*moisture, *texture, *geology}.make(input, spread_.result(), climate, rect);
    return !same_cells(*moisture, *moisture_before, rect) || !same_cells(*texture, *texture_before, rect) ||
           !same_cells(*geology, *geology_before, rect);
  });
  moisture_.put(std::move(moisture), changed);
  texture_.put(std::move(texture), changed);
  geology_.put(std::move(geology), changed);
  if (changed.any()) changes_.note(changed);
}

void SoilState::forget_passes() {
  spread_.forget();
  surroundings_.forget();
}

MonthlyMap SoilState::moisture(const Climate& climate) const { return {{moisture_.newest()}, moisture_offsets(climate)}; }

void SoilState::release_unused() {
  moisture_.release_unused();
  texture_.release_unused();
  geology_.release_unused();
}

}  // namespace biotope
