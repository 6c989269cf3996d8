#include "core/ecosystem/plant_shortage.hpp"

#include <catch2/catch.hpp>

#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using namespace biotope::plant_scene;

namespace {

std::shared_ptr<const CoverMap> covered(int side, float fraction) {
  return std::make_shared<const CoverMap>(side, side, to_cover(fraction));
}

std::shared_ptr<const PaintLayer> painted_rect(int side, const Rect& rect) {
  auto layer = std::make_shared<PaintLayer>(side, side);
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) layer->set(x, y, {0.5F, 1});
  }
  return layer;
}

}  // namespace

TEST_CASE("paint where a plant cannot live is told with its place, area and what does not suit") {
  constexpr int side = 100;
  Scene scene(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 60; x < side; ++x) scene.set(Resource::moisture, x, y, constant(2));
  }
  PlantTraits alder = easy_plant();
  alder.moisture = {4, 9};
  const FoodWeb web = web_of({{"alder", alder}, {"moss", easy_plant()}});
  const std::vector<std::shared_ptr<const CoverMap>> covers{covered(side, 0.5F), covered(side, 0.5F)};

  SECTION("painted half on dry ground: the dry half is told") {
    const std::vector<std::shared_ptr<const PaintLayer>> paint{painted_rect(side, {50, 20, 70, 40}),
                                                               painted_rect(side, {50, 20, 70, 40})};
    const auto shortages = plant_shortages(web, scene.environment(), covers, paint, 2);
    REQUIRE(shortages.size() == 1);
    CHECK(shortages[0].species == 0);
    CHECK(shortages[0].area == Approx(10 * 20 * 4));
    CHECK(shortages[0].limiting == LimitingFactor::moisture);
    CHECK(shortages[0].x >= 60);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const bool dry_and_painted = x >= 60 && x < 70 && y >= 20 && y < 40;
        REQUIRE(((*shortages[0].where)(x, y).coverage > 0) == dry_and_painted);
      }
    }
    Terrain terrain;
    terrain.height = Grid<float>(side, side);
    terrain.cell_size = 2;
    const Warning warning = shortage_warning(web, terrain, shortages[0]);
    CHECK(warning.text.find("moisture") != std::string::npos);
    CHECK(warning.species == 0);
    CHECK(warning.amount == Approx(10 * 20 * 4));
    REQUIRE(warning.place);
    CHECK(warning.place->x == float(shortages[0].x));
    CHECK(warning.place->y == float(shortages[0].y));
    // Places are read in metres from the south-west corner.
    const int east = 2 * shortages[0].x + 1;
    CHECK(warning.text.find("(near x " + std::to_string(east) + " m, y ") != std::string::npos);
  }
  SECTION("painted on wet ground only: nothing to tell") {
    const std::vector<std::shared_ptr<const PaintLayer>> paint{painted_rect(side, {10, 20, 50, 40}), nullptr};
    CHECK(plant_shortages(web, scene.environment(), covers, paint, 2).empty());
  }
  SECTION("paint that takes plants away asks for nothing") {
    const std::vector<std::shared_ptr<const CoverMap>> bare{covered(side, 0), covered(side, 0)};
    const std::vector<std::shared_ptr<const PaintLayer>> paint{painted_rect(side, {50, 20, 90, 40}), nullptr};
    CHECK(plant_shortages(web, scene.environment(), bare, paint, 2).empty());
  }
}
