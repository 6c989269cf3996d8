#include "core/ecosystem/fitness.hpp"

#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using plant_scene::constant;
using plant_scene::easy_plant;
using plant_scene::Year;

namespace {

/// Half the months `a`, then half `b`.
Year seasons(float a, float b) {
  Year year = constant(a);
  for (std::size_t m = 6; m < months; ++m) year[m] = b;
  return year;
}

CellEnvironment kind_cell() {
  CellEnvironment cell;
  for (Year& year : cell.monthly) year = constant(5);
  cell.texture = 5;
  return cell;
}

}  // namespace

TEST_CASE("A constant year counts as a point: 1 inside the range, ends included, 0 outside") {
  CHECK(resource_fitness({3, 6}, constant(4)) == 1.0F);
  CHECK(resource_fitness({3, 6}, constant(3)) == 1.0F);
  CHECK(resource_fitness({3, 6}, constant(6)) == 1.0F);
  CHECK(resource_fitness({3, 6}, constant(2.999F)) == 0.0F);
  CHECK(resource_fitness({3, 6}, constant(6.001F)) == 0.0F);
  CHECK(resource_fitness({4, 4}, constant(4)) == 1.0F);
}

TEST_CASE("Fitness is the mean over twelve intervals of the share inside the range") {
  // Ten intervals are points; July's start and December's end cross from 2 to 6, half of each within 4..9.
  CHECK(resource_fitness({4, 9}, seasons(2, 6)) == Approx((5 + 2 * 0.5) / 12));
  // The crossing intervals alone, by a quarter each.
  CHECK(resource_fitness({3, 4}, seasons(2, 6)) == Approx(2 * 0.25 / 12));
  // A range of one point has no length within an interval.
  CHECK(resource_fitness({4, 4}, seasons(2, 6)) == 0.0F);
}

TEST_CASE("The year closes: December runs into January") {
  Year year = constant(5);
  year[11] = 9;
  CHECK(resource_fitness({5, 5}, year) == Approx(10.0 / 12));
  CHECK(resource_fitness({5, 9}, year) == 1.0F);
  CHECK(resource_fitness({7, 9}, year) == Approx(2 * 0.5 / 12));
}

TEST_CASE("Ranges that tile the scale share the year between them") {
  for (std::uint64_t sample = 0; sample < 200; ++sample) {
    Year year{};
    for (std::size_t m = 0; m < months; ++m) year[m] = 1 + 8 * float(random_unit({sample, m}));
    const float cut = 1 + 8 * float(random_unit({sample, 99}));
    const float low = resource_fitness({1, cut}, year);
    const float high = resource_fitness({cut, 9}, year);
    CHECK(low + high == Approx(1.0F).margin(1e-5));
    CHECK(resource_fitness({1, 9}, year) == 1.0F);
  }
}

TEST_CASE("The scarcest resource decides, and is named") {
  PlantTraits plant = easy_plant();
  CellEnvironment cell = kind_cell();
  CHECK(plant_fitness(plant, cell).value == 1.0F);
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::none);

  cell.monthly[std::size_t(Resource::moisture)] = seasons(2, 6);
  plant.moisture = {4, 9};
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::moisture);
  CHECK(plant_fitness(plant, cell).value == Approx(0.5));

  plant.temperature = {6, 9};
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::temperature);
  CHECK(plant_fitness(plant, cell).value == 0.0F);

  plant.illumination = {6, 9};
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::illumination);
}

TEST_CASE("Texture is in or out of the range, geology gives its viability") {
  PlantTraits plant = easy_plant();
  CellEnvironment cell = kind_cell();
  plant.texture = {1, 5};
  CHECK(plant_fitness(plant, cell).value == 1.0F);
  cell.texture = 5.5F;
  CHECK(plant_fitness(plant, cell).value == 0.0F);
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::texture);

  cell.texture = 5;
  cell.geology = int(Geology::water);
  plant.geology = {0, 0.8F, 0, 0, 1};
  CHECK(plant_fitness(plant, cell).value == 0.8F);
  CHECK(plant_fitness(plant, cell).limiting == LimitingFactor::geology);
}

TEST_CASE("Every limiting factor has a name") {
  CHECK(to_string(LimitingFactor::none) == "none");
  CHECK(to_string(LimitingFactor::illumination) == "illumination");
  CHECK(to_string(LimitingFactor::temperature) == "temperature");
  CHECK(to_string(LimitingFactor::moisture) == "moisture");
  CHECK(to_string(LimitingFactor::texture) == "texture");
  CHECK(to_string(LimitingFactor::geology) == "geology");
}
