// The year of plants on both hemispheres.
#include "render/season.hpp"

#include "render/ground_maps.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

GroundColours colours(double latitude, int month) {
  auto snapshot = level_landscape();
  auto terrain = std::make_shared<Terrain>(snapshot->terrain());
  terrain->latitude = latitude;
  snapshot->document.terrain = terrain;
  cover(*snapshot, 0, 0.5F);
  cover(*snapshot, 3, 0.5F);
  return colour_ground(*snapshot, month, {}, 1, {0, 0, 8, 8});
}

bool same(const GroundColours& a, const GroundColours& b) { return a.ground == b.ground && a.canopy == b.canopy; }

}  // namespace

TEST_CASE("south of the equator plants have the other half of the year") {
  for (int month = 0; month < 12; ++month) {
    CHECK(northern_month(month, 45) == month);
    CHECK(northern_month(month, -45) == (month + 6) % 12);
    CHECK(same(colours(-45, month), colours(45, (month + 6) % 12)));
  }
  CHECK_FALSE(same(colours(-45, 0), colours(45, 0)));
}
