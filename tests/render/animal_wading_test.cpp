#include "render/animal_wading.hpp"

#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Level ground with a river along columns 60 to 67, as animals know it, and maybe a ford in row 64.
std::shared_ptr<const HerdWorld> riverside(bool ford) {
  const auto landscape = level_landscape();
  auto world = std::make_shared<HerdWorld>();
  world->web = landscape->web;
  world->ground.terrain = landscape->document.terrain;
  world->ground.hydrology = river(60, 68);
  auto places = std::make_shared<Places>();
  if (ford) places->fords.push_back({{64, 64}, 24});
  world->ground.places = places;
  return world;
}

/// The middle of the river in row 64.
constexpr Place midstream{64 * cell_size + 2, (cells - 64) * cell_size - 2};
constexpr Place meadow{20 * cell_size, 64 * cell_size};

}  // namespace

TEST_CASE("animals stand below the surface of a river, on the ground beside it, and less deep at a ford") {
  const AnimalWading deep(riverside(false));
  const AnimalWading shallow(riverside(true));
  CHECK(deep.depth(meadow) == 0);
  CHECK(deep.depth(midstream) > 0.4);
  CHECK(shallow.depth(midstream) > 0.05);
  CHECK(shallow.depth(midstream) < 0.35);
  CHECK(AnimalWading().depth(midstream) == 0);
}

TEST_CASE("who wades has its feet on the bed; in water that is deeper than it is high an animal swims") {
  const AnimalWading wading(riverside(false));
  const double depth = wading.depth(midstream);
  CHECK(wading.feet(midstream, 100, 100, 1.4) == Approx(100 - depth));
  CHECK(wading.feet(meadow, 100, 100, 1.4) == 100);
  // A lake's bed, 5 m below: the back stays above the surface.
  const double feet = wading.feet(meadow, 100, 95, 1.0);
  CHECK(feet > 99);
  CHECK(feet < 99.5);
}

TEST_CASE("heads are up in deep water and free at its edge") {
  CHECK(AnimalWading::head_up(0.05, 1.0) == 0);
  CHECK(AnimalWading::head_up(0.5, 1.0) == 1);
}
