#include "core/ecosystem/plant_competition.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "tests/ecosystem/plant_competition_reference.hpp"
#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using plant_scene::constant;
using plant_scene::easy_plant;
using plant_scene::Scene;
using plant_scene::Year;

namespace {

std::vector<CoverMap> compete(const FoodWeb& web, const PlantEnvironment& environment) {
  auto covers = compete_without_proportions(web, environment);
  REQUIRE(covers.has_value());
  return *covers;
}

/// The covers of a single cell whose illumination, temperature and moisture do not change over the year.
std::vector<int> compete_in_cell(const FoodWeb& web, float light, float warmth, float water) {
  Scene scene(1, 1);
  scene.fill(Resource::illumination, constant(light));
  scene.fill(Resource::temperature, constant(warmth));
  scene.fill(Resource::moisture, constant(water));
  std::vector<int> covers;
  for (const CoverMap& map : compete(web, scene.environment())) covers.push_back(int(map(0, 0)));
  return covers;
}

/// Years whose steps from month to month are powers of two or nothing, so that every sum in floats is exact.
Year exact_year(std::uint64_t seed, std::uint64_t what) {
  constexpr std::array<float, 8> steps{0, 0, 0.25F, 0.5F, 1, 2, -0.5F, -1};
  Year year{};
  float value = float(random_int(4, 32, {seed, what, 1})) * 0.25F;
  for (std::size_t m = 0; m < 6; ++m) {
    year[m] = year[11 - m] = value;
    const float next = value + steps[std::size_t(random_int(0, 7, {seed, what, m, 2}))];
    if (next >= 1 && next <= 9) value = next;
  }
  return year;
}

Year rough_year(std::uint64_t seed, std::uint64_t what) {
  Year year{};
  const double base = 1 + 8 * random_unit({seed, what, 1});
  const double swing = 3 * random_unit({seed, what, 2});
  for (std::size_t m = 0; m < months; ++m) {
    year[m] = float(std::clamp(base + swing * (2 * random_unit({seed, what, m, 3}) - 1), 1.0, 9.0));
  }
  return year;
}

Scene random_scene(int width, int height, std::uint64_t seed, Year (*year)(std::uint64_t, std::uint64_t)) {
  Scene scene(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint64_t cell = random_bits({seed, std::uint64_t(x), std::uint64_t(y)});
      for (std::uint64_t r = 0; r < monthly_resources; ++r) scene.set(Resource(r), x, y, year(cell, r));
      scene.texture()(x, y) = float(random_int(1, 9, {cell, 10}));
      scene.geology()(x, y) = Geology(random_int(0, geology_classes - 1, {cell, 11}));
    }
  }
  return scene;
}

/// A flora of random needs in sixteenths of an index.
FoodWeb random_flora(std::uint64_t seed, int plants) {
  constexpr std::array<float, 4> units{1.0F / 20, 1.0F / 16, 1.0F / 12, 1.0F / 10};
  std::vector<std::pair<std::string, PlantTraits>> list;
  for (std::uint64_t i = 0; i < std::uint64_t(plants); ++i) {
    PlantTraits plant = easy_plant(Stratum(random_int(0, strata - 1, {seed, i, 1})));
    const auto range = [&](std::uint64_t what) {
      const int low = random_int(2, 16, {seed, i, what, 2});
      return Range{float(low) / 2, float(low + random_int(0, 9, {seed, i, what, 3})) / 2};
    };
    plant.illumination = range(1);
    plant.temperature = Range{1, float(random_int(3, 9, {seed, i, 4}))};
    plant.moisture = range(3);
    plant.light_consumption = float(random_int(0, 20, {seed, i, 5})) / 4;
    plant.water_consumption = float(random_int(0, 20, {seed, i, 6})) / 4;
    plant.unit_cover = units[std::size_t(random_int(0, 3, {seed, i, 7}))];
    plant.geology[2] = 0.5F;
    list.emplace_back("plant-" + std::to_string(i), plant);
  }
  return plant_scene::web_of(std::move(list));
}

CellEnvironment cell_of(const PlantEnvironment& environment, int x, int y) { return environment.cell(x, y); }

}  // namespace

TEST_CASE("A plant alone in a perfect place covers all of it, exactly") {
  CHECK(compete_in_cell(plant_scene::web_of({{"grass", easy_plant()}}), 5, 5, 5) == std::vector{240});
}

TEST_CASE("A plant that shades itself stops when its own shade is too dark") {
  PlantTraits pinus = easy_plant(Stratum::tree);
  pinus.illumination = {7, 9};
  pinus.light_consumption = 5;
  // Each unit of 1/20 takes 0.25: at index 7.0, after 0.40, one more still fits; at 6.75 none.
  CHECK(compete_in_cell(plant_scene::web_of({{"pinus", pinus}}), 9, 5, 5) == std::vector{108});
}

TEST_CASE("A plant stops when its own thirst has dried the place") {
  PlantTraits alder = easy_plant(Stratum::tree);
  alder.moisture = {4, 9};
  alder.water_consumption = 5;
  CHECK(compete_in_cell(plant_scene::web_of({{"alder", alder}}), 9, 5, 4) == std::vector{12});
  CHECK(compete_in_cell(plant_scene::web_of({{"alder", alder}}), 9, 5, 3.99F) == std::vector{0});
}

TEST_CASE("Nobody takes the last of a resource: more must be left than a unit takes") {
  PlantTraits thirsty = easy_plant();
  thirsty.moisture = {-9, 9};
  thirsty.water_consumption = 5;
  // 1.0 is left: three units of 0.25 leave 0.25, which is not more than the fourth takes.
  CHECK(compete_in_cell(plant_scene::web_of({{"moss", thirsty}}), 9, 5, 1) == std::vector{36});
}

TEST_CASE("Equal plants share the ground equally, the first listed first") {
  const FoodWeb web = plant_scene::web_of({{"a", easy_plant()}, {"b", easy_plant()}, {"c", easy_plant()}});
  CHECK(compete_in_cell(web, 5, 5, 5) == std::vector{84, 84, 72});
}

TEST_CASE("The fitter plant takes the ground first") {
  PlantTraits best = easy_plant();
  PlantTraits half = easy_plant();
  half.geology[0] = 0.5F;
  // Until crowding brings the fitter down to one half it takes every unit; the tie at one half is its own, then they alternate.
  CHECK(compete_in_cell(plant_scene::web_of({{"best", best}, {"half", half}}), 5, 5, 5) == std::vector{132, 108});
}

TEST_CASE("Strata share a cell's ground from above, not each other's") {
  const FoodWeb web = plant_scene::web_of(
      {{"herb", easy_plant(Stratum::herb)}, {"shrub", easy_plant(Stratum::shrub)}, {"tree", easy_plant(Stratum::tree)}});
  CHECK(compete_in_cell(web, 5, 5, 5) == std::vector{240, 240, 240});
}

TEST_CASE("Shade drives out what needs light and lets in what cannot stand it") {
  PlantTraits tree = easy_plant(Stratum::tree);
  tree.light_consumption = 5;
  PlantTraits sunny = easy_plant(Stratum::herb);
  sunny.illumination = {6, 9};
  PlantTraits shady = easy_plant(Stratum::herb);
  shady.illumination = {1, 4};
  const FoodWeb open = plant_scene::web_of({{"sunny", sunny}, {"shady", shady}});
  CHECK(compete_in_cell(open, 9, 5, 5) == std::vector{240, 0});
  const FoodWeb wood = plant_scene::web_of({{"sunny", sunny}, {"shady", shady}, {"tree", tree}});
  CHECK(compete_in_cell(wood, 9, 5, 5) == std::vector{0, 240, 240});
}

TEST_CASE("Water bodies hold only what is viable in water") {
  PlantTraits alder = easy_plant(Stratum::tree);
  alder.geology = {0, 0.8F, 0, 0, 1};
  PlantTraits oak = easy_plant(Stratum::tree);
  oak.geology = {1, 0, 1, 1, 1};
  Scene scene(1, 1);
  scene.geology()(0, 0) = Geology::water;
  const auto covers = compete(plant_scene::web_of({{"alder", alder}, {"oak", oak}}), scene.environment());
  CHECK(int(covers[0](0, 0)) == 240);
  CHECK(int(covers[1](0, 0)) == 0);
}

TEST_CASE("Paint moves every month by the same amount and keeps the seasons") {
  Scene scene(2, 1);
  Year year = constant(3);
  year[6] = 5;
  scene.fill(Resource::moisture, year);
  PlantEnvironment environment = scene.environment();
  PaintLayer paint(2, 1);
  const float mean = (11 * 3 + 5) / 12.0F;
  paint.set(1, 0, Paint{mean + 2, 0.5F});
  environment.paint[std::size_t(Resource::moisture)] = std::make_shared<const PaintLayer>(paint);
  const CellEnvironment bare = environment.cell(0, 0);
  const CellEnvironment wet = environment.cell(1, 0);
  for (std::size_t m = 0; m < months; ++m) {
    CHECK(bare.monthly[2][m] == year[m]);
    CHECK(wet.monthly[2][m] == Approx(year[m] + 1));
  }
  paint.set(1, 0, Paint{9, 1});
  environment.paint[2] = std::make_shared<const PaintLayer>(paint);
  CHECK(environment.cell(1, 0).monthly[2][6] == 9.0F);
}

TEST_CASE("Competition is the documents' algorithm, unit by unit, where arithmetic is exact") {
  const Scene scene = random_scene(64, 48, 7, exact_year);
  const PlantEnvironment environment = scene.environment();
  for (std::uint64_t flora = 0; flora < 4; ++flora) {
    const FoodWeb web = flora == 0 ? plant_scene::thesis_flora() : random_flora(flora, 5 + int(flora) * 4);
    const auto covers = compete(web, environment);
    int grown = 0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        const auto expected = plant_reference::compete(web, cell_of(environment, x, y));
        for (std::size_t i = 0; i < covers.size(); ++i) {
          grown += expected.cover[i] > 0 ? 1 : 0;
          if (int(covers[i](x, y)) != expected.cover[i]) {
            CAPTURE(flora, x, y, i);
            REQUIRE(int(covers[i](x, y)) == expected.cover[i]);
          }
        }
      }
    }
    CHECK(grown > 1000);
  }
}

TEST_CASE("Competition is the documents' algorithm on any year, but for decisions closer than rounding") {
  const Scene scene = random_scene(61, 50, 8, rough_year);
  const PlantEnvironment environment = scene.environment();
  const FoodWeb web = plant_scene::thesis_flora();
  const auto covers = compete(web, environment);
  int compared = 0;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 61; ++x) {
      double narrowest = 0;
      const auto expected = plant_reference::compete(web, cell_of(environment, x, y), &narrowest);
      if (narrowest < 1e-3) continue;
      ++compared;
      for (std::size_t i = 0; i < covers.size(); ++i) {
        if (int(covers[i](x, y)) != expected.cover[i]) {
          CAPTURE(x, y, i, narrowest);
          REQUIRE(int(covers[i](x, y)) == expected.cover[i]);
        }
      }
    }
  }
  CHECK(compared > 2500);
}

TEST_CASE("A cell's plants do not depend on the tile, its borders or the number of threads") {
  const Scene scene = random_scene(150, 70, 9, rough_year);
  PlantEnvironment environment = scene.environment();
  PaintLayer paint(150, 70);
  for (int x = 40; x < 100; ++x) paint.set(x, 20, Paint{float(x) / 12, 0.7F});
  environment.paint[0] = std::make_shared<const PaintLayer>(paint);
  const FoodWeb web = plant_scene::thesis_flora();
  const auto covers = compete(web, environment);

  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  CHECK(compete(web, environment) == covers);

  // The same cells in pieces of odd sizes.
  for (const Rect piece : {Rect{64, 0, 67, 9}, Rect{71, 13, 128, 64}, Rect{149, 69, 150, 70}}) {
    std::vector<CoverMap::Tile> tiles(covers.size());
    std::vector<CoverMap::Tile*> out;
    for (auto& tile : tiles) out.push_back(&tile);
    compete_in_tile(web, environment, piece, out);
    for (std::size_t i = 0; i < covers.size(); ++i) {
      for (int y = piece.y0; y < piece.y1; ++y) {
        for (int x = piece.x0; x < piece.x1; ++x) {
          if (tiles[i][CoverMap::offset(x, y)] != covers[i](x, y)) FAIL("cell " << x << ", " << y << " of plant " << i);
        }
      }
    }
  }
}

TEST_CASE("A stopped competition gives nothing, one that runs reports to the end") {
  const Scene scene = random_scene(10, 10, 9, rough_year);
  double last = -1;
  TaskContext context;
  context.progress = [&](std::string_view, double fraction) { last = fraction; };
  CHECK(compete_without_proportions(plant_scene::thesis_flora(), scene.environment(), context).has_value());
  CHECK(last == 1.0);
  std::stop_source source;
  source.request_stop();
  context.stop = source.get_token();
  CHECK_FALSE(compete_without_proportions(plant_scene::thesis_flora(), scene.environment(), context).has_value());
}

TEST_CASE("Shares of cover are of what grows, and zero where nothing does") {
  CoverMap oak(3, 1);
  CoverMap grass(3, 1);
  const std::vector<CoverMap> bare{oak, grass};
  CHECK(achieved_shares(bare) == std::vector<double>{0, 0});
  oak.set(0, 0, 60);
  grass.set(1, 0, 120);
  grass.set(2, 0, 60);
  const std::vector<CoverMap> covers{oak, grass};
  CHECK(achieved_shares(covers) == std::vector<double>{0.25, 0.75});
}

TEST_CASE("The fitness map is the fitness of every cell before competition") {
  const Scene scene = random_scene(20, 15, 3, rough_year);
  const PlantEnvironment environment = scene.environment();
  const FoodWeb web = plant_scene::thesis_flora();
  const PlantTraits& poaceae = web.species[6].plant();
  const Grid<float> fitness = fitness_map(poaceae, environment);
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) {
      if (fitness(x, y) != plant_fitness(poaceae, environment.cell(x, y)).value) FAIL("cell " << x << ", " << y);
    }
  }
}
