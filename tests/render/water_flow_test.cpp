#include "render/water_flow.hpp"

#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Ground that falls by `fall` m from row to row, so that the sample river runs south.
Terrain falling_south(float fall) {
  Terrain terrain;
  terrain.height = Grid<float>(cells, cells);
  terrain.cell_size = cell_size;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) terrain.height(x, y) = 500 - fall * float(y);
  }
  return terrain;
}

}  // namespace

TEST_CASE("a deeper or steeper stream is faster, up to a bound, and a level one creeps") {
  CHECK(stream_speed(0.5F, 0.01F) == Approx(std::pow(0.5, 2.0 / 3) * 0.1 / 0.045));
  CHECK(stream_speed(1.0F, 0.01F) > stream_speed(0.5F, 0.01F));
  CHECK(stream_speed(0.5F, 0.02F) > stream_speed(0.5F, 0.01F));
  CHECK(stream_speed(5, 0.5F) == fastest_flow);
  CHECK(stream_speed(0.5F, 0) > 0);
}

TEST_CASE("water flows along its reach, downstream, and nowhere else") {
  const auto hydrology = river(60, 68);
  const Grid<Rgba> flow = water_flow(falling_south(0.05F), *hydrology, 1);
  const Rgba middle = flow(64, 64);
  CHECK(int(middle[0]) == Approx(128).margin(1));
  CHECK(middle[1] < 120);  // to the south
  CHECK(int(middle[2]) == Approx(0.8 / deepest_water * 255).margin(2));
  CHECK(flow(10, 64) == Rgba{128, 128, 0, 0});
}

TEST_CASE("a steep reach is rough and a lake stands") {
  auto hydrology = *river(60, 68);
  const Grid<Rgba> gentle = water_flow(falling_south(0.01F), hydrology, 1);
  const Grid<Rgba> steep = water_flow(falling_south(1), hydrology, 1);
  CHECK(gentle(64, 64)[3] == 0);
  CHECK(steep(64, 64)[3] > 200);
  for (std::size_t i = 0; i < hydrology.water.size(); ++i) {
    if (hydrology.water[i] == WaterKind::river) hydrology.water[i] = WaterKind::lake;
  }
  hydrology.reaches.clear();
  const Grid<Rgba> lake = water_flow(falling_south(0), hydrology, 1);
  CHECK(lake(64, 64)[0] == 128);
  CHECK(lake(64, 64)[1] == 128);
  CHECK(lake(64, 64)[2] > 0);
  CHECK(lake(64, 64)[3] == 0);
}

TEST_CASE("currents of a coarser texture are those of the same places") {
  const auto hydrology = river(60, 68);
  const Grid<Rgba> coarse = water_flow(falling_south(0.05F), *hydrology, 4);
  CHECK(coarse.width() == cells / 4);
  CHECK(coarse(16, 16)[1] < 120);
  CHECK(coarse(2, 16) == Rgba{128, 128, 0, 0});
}

TEST_CASE("at a ford the stream is shallow and breaks, and nowhere else") {
  const auto hydrology = river(60, 68);
  const Terrain terrain = falling_south(0.01F);
  const FordLook ford({{64, 40, 6}});
  const Grid<Rgba> with = water_flow(terrain, *hydrology, 1, ford);
  const Grid<Rgba> without = water_flow(terrain, *hydrology, 1);
  CHECK(int(with(64, 40)[2]) < int(without(64, 40)[2]) / 2);
  CHECK(with(64, 40)[3] > 100);
  CHECK(without(64, 40)[3] == 0);
  CHECK(with(64, 90) == without(64, 90));
}
