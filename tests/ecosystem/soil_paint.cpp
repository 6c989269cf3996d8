#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "plant_scene.hpp"

using namespace biotope;
using namespace biotope::plant_scene;

namespace {

std::shared_ptr<const PaintLayer> layer(const PaintLayer& paint) { return std::make_shared<const PaintLayer>(paint); }

std::vector<CoverMap> compete(const FoodWeb& web, const PlantEnvironment& environment) {
  return compete_without_proportions(web, environment).value();
}

/// The same world with the paint in the maps instead of over them.
PlantEnvironment baked(const PlantEnvironment& painted) {
  auto maps = std::make_shared<EnvironmentMaps>(*painted.maps);
  Grid<float> texture = *maps->texture;
  Grid<Geology> geology = *maps->geology;
  for (int y = 0; y < texture.height(); ++y) {
    for (int x = 0; x < texture.width(); ++x) {
      texture(x, y) = painted.texture(x, y);
      geology(x, y) = painted.geology(x, y);
    }
  }
  maps->texture = std::make_shared<const Grid<float>>(std::move(texture));
  maps->geology = std::make_shared<const Grid<Geology>>(std::move(geology));
  return PlantEnvironment{maps, painted.paint, {}};
}

}  // namespace

TEST_CASE("painted geology counts where it covers half a cell or more, and shifts what can live there") {
  PlantTraits lime = easy_plant();
  lime.geology = {1, 0, 0.5F, 0, 0};
  Scene scene(5, 1);
  PlantEnvironment environment = scene.environment();
  PaintLayer paint(5, 1);
  paint.set(1, 0, {float(Geology::marl), 0.5F});
  paint.set(2, 0, {float(Geology::marl), 0.49F});
  paint.set(3, 0, {float(Geology::scree), 1});
  paint.set(4, 0, {99, 1});
  environment.soil.geology = layer(paint);
  CHECK(environment.geology(0, 0) == Geology::limestone);
  CHECK(environment.geology(4, 0) == Geology::alluvium);
  const Grid<float> fitness = fitness_map(lime, environment);
  CHECK(fitness(0, 0) == 1);
  CHECK(fitness(1, 0) == 0.5F);
  CHECK(fitness(2, 0) == 1);
  CHECK(fitness(3, 0) == 0);
  const auto covers = compete(web_of({{"lime", lime}}), environment);
  CHECK(covers[0](2, 0) == full_cover);
  CHECK(covers[0](3, 0) == 0);
}

TEST_CASE("painted texture is mixed by its coverage and stays on the scale") {
  PlantTraits clay = easy_plant();
  clay.texture = {1, 4};
  Scene scene(4, 1);
  PlantEnvironment environment = scene.environment();
  PaintLayer paint(4, 1);
  paint.set(1, 0, {3, 0.5F});
  paint.set(2, 0, {2, 0.3F});
  paint.set(3, 0, {-40, 1});
  environment.soil.texture = layer(paint);
  CHECK(environment.texture(0, 0) == 5);
  CHECK(environment.texture(1, 0) == 4);
  CHECK(environment.texture(3, 0) == 1);
  const auto covers = compete(web_of({{"clay", clay}}), environment);
  CHECK(covers[0](0, 0) == 0);
  CHECK(covers[0](1, 0) == full_cover);
  CHECK(covers[0](2, 0) == 0);
  CHECK(covers[0](3, 0) == full_cover);
}

TEST_CASE("soil under paint gives the same plants, to the bit, as the same soil without") {
  Scene scene(150, 70);
  PaintLayer texture(150, 70);
  PaintLayer geology(150, 70);
  for (int y = 0; y < 70; ++y) {
    for (int x = 0; x < 150; ++x) {
      const auto chance = [&](std::uint64_t what) { return float(random_unit({3, what, std::uint64_t(x), std::uint64_t(y)})); };
      scene.texture()(x, y) = 1 + 8 * chance(1);
      scene.geology()(x, y) = Geology(int(5 * chance(2)));
      if (x < 80) texture.set(x, y, {12 * chance(3) - 1, chance(4)});
      if (x > 40) geology.set(x, y, {5 * chance(5) - 0.5F, chance(6)});
    }
  }
  PlantEnvironment environment = scene.environment();
  environment.soil = {layer(texture), layer(geology)};
  const FoodWeb web = thesis_flora();
  const auto covers = compete(web, environment);
  CHECK(covers == compete(web, baked(environment)));
  CHECK(covers != compete(web, scene.environment()));
  const std::vector<double> desired(18, 1.0 / 18);
  const auto shared = compete_with_proportions(web, environment, desired).value();
  CHECK(shared == compete_with_proportions(web, baked(environment), desired).value());
  CHECK(shared != compete_with_proportions(web, scene.environment(), desired).value());
}

TEST_CASE("soil paint that covers nothing changes nothing") {
  Scene scene(20, 20);
  PlantEnvironment environment = scene.environment();
  PaintLayer paint(20, 20);
  paint.set(3, 3, {4, 0});
  environment.soil = {layer(paint), layer(paint)};
  CHECK(compete(thesis_flora(), environment) == compete(thesis_flora(), scene.environment()));
}
