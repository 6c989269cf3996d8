#include "core/ecosystem/plant_share_schedule.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "core/base/random.hpp"
#include "core/ecosystem/plant_share_giving.hpp"
#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using plant_scene::easy_plant;
using plant_scene::Scene;
using plant_scene::Year;

namespace {

/// Hills in light, warmth and water with seasons: no two cells alike.
Scene rolling_scene(int width, int height) {
  Scene scene(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int r = 0; r < int(monthly_resources); ++r) {
        const double hills =
            std::sin(0.031 * (x + 40 * r)) * std::cos(0.023 * (y - 25 * r)) + 0.4 * std::sin(0.11 * (x + y + 9 * r));
        const double noise = random_unit({7, std::uint64_t(x), std::uint64_t(y), std::uint64_t(r)}) - 0.5;
        Year year{};
        for (int m = 0; m < months; ++m) {
          year[std::size_t(m)] =
              float(std::clamp(5.5 + 1.8 * hills + 0.3 * noise - 1.2 * std::cos(m * 3.14159265 / 6), 1.0, 9.0));
        }
        scene.set(Resource(r), x, y, year);
      }
      scene.geology()(x, y) = y < height / 5 ? Geology::alluvium : Geology::limestone;
    }
  }
  return scene;
}

/// Paper algorithm 1 over every cell, equally fit ones in the order of the queue.
std::vector<CoverMap> unit_by_unit(const FoodWeb& web, const PlantEnvironment& environment, const std::vector<double>& desired) {
  const Rect area = environment.maps->geology->rect();
  CellList cells;
  for (int y = 0; y < area.height(); ++y) {
    for (int x = 0; x < area.width(); ++x) cells.push_back({x, y});
  }
  std::ranges::sort(cells, {}, [](const std::array<int, 2>& cell) { return place_in_queue(cell[0], cell[1]); });
  const auto wanted = wanted_plants(web, desired);
  SharedLandscape landscape(wanted, environment, cells);
  REQUIRE(give_out(landscape, wanted, desired, {}, [](std::size_t, SharedLandscape::Place) {}));
  std::vector<CoverMap> covers(desired.size(), CoverMap(area.width(), area.height()));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    covers[std::size_t(wanted[i].plant)] = landscape.cover_map(i, area.width(), area.height());
  }
  return covers;
}

double mean_cover(const CoverMap& map, const Rect& part) {
  double sum = 0;
  for (int y = part.y0; y < part.y1; ++y) {
    for (int x = part.x0; x < part.x1; ++x) sum += double(map(x, y));
  }
  return sum / (double(full_cover) * part.width() * part.height());
}

}  // namespace

TEST_CASE("The sample has a cell of every block, each once, and no more than algorithm 1 can take") {
  for (const auto& [width, height] : {std::pair(1024, 1024), std::pair(4096, 4096), std::pair(129, 128), std::pair(3000, 40)}) {
    const CellList cells = share_sample(width, height);
    CAPTURE(width, height, cells.size());
    CHECK(int(cells.size()) <= most_share_cells);
    CHECK(int(cells.size()) > most_share_cells / 5);
    CHECK(std::set(cells.begin(), cells.end()).size() == cells.size());
    for (const auto& [x, y] : cells) REQUIRE((x >= 0 && x < width && y >= 0 && y < height));
  }
}

TEST_CASE("By a schedule, shares that can be had everywhere are met, and everywhere alike") {
  const FoodWeb web = plant_scene::web_of({{"a", easy_plant()}, {"b", easy_plant()}, {"c", easy_plant()}, {"d", easy_plant()}});
  const std::vector<double> desired{0.5, 0.3, 0.2, 0};
  const auto covers = compete_with_proportions(web, Scene(200, 150).environment(), desired);
  REQUIRE(covers);
  const auto shares = achieved_shares(*covers);
  for (std::size_t i = 0; i < 4; ++i) CHECK(shares[i] == Approx(desired[i]).margin(0.01));
  for (int y = 0; y < 150; y += 50) {
    for (int x = 0; x < 200; x += 50) {
      double all = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double mean = mean_cover((*covers)[i], {x, y, x + 50, y + 50});
        CHECK(mean == Approx(desired[i]).margin(0.02));
        all += mean;
      }
      CHECK(all == Approx(1));
    }
  }
}

TEST_CASE("A schedule leads where the paper's algorithm 1 leads, in shares and in places") {
  const FoodWeb web = plant_scene::thesis_flora();
  const Scene scene = rolling_scene(260, 220);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    std::vector<double> desired(18, 0);
    for (std::uint64_t i = 0; i < 40; ++i) desired[std::size_t(random_int(0, 17, {seed, i}))] += 1.0 / 40;
    const auto expected = unit_by_unit(web, scene.environment(), desired);
    const auto covers = compete_with_proportions(web, scene.environment(), desired);
    REQUIRE(covers);
    const auto should = achieved_shares(expected);
    const auto shares = achieved_shares(*covers);
    double off = 0;
    for (std::size_t i = 0; i < 18; ++i) off += std::abs(shares[i] - should[i]) / 18;
    CHECK(off < 0.01);
    for (std::size_t i = 0; i < 18; ++i) {
      CAPTURE(seed, i, web.species[i].name, desired[i], should[i]);
      CHECK(shares[i] == Approx(should[i]).margin(0.03));
      for (int y = 0; y < 220; y += 44) {
        for (int x = 0; x < 260; x += 52) {
          const Rect part{x, y, x + 52, y + 44};
          CHECK(mean_cover((*covers)[i], part) == Approx(mean_cover(expected[i], part)).margin(0.1));
        }
      }
    }
  }
}

TEST_CASE("By a schedule a cell's plants do not depend on the tile, its parts or the plants that nobody wants") {
  const FoodWeb web = plant_scene::thesis_flora();
  const Scene scene = rolling_scene(150, 140);
  const PlantEnvironment environment = scene.environment();
  std::vector<double> desired(18, 0);
  for (const std::size_t i : {1, 3, 6, 8, 10, 14, 16}) desired[i] = 1.0 / 7;
  const auto schedule = share_schedule(web, environment, desired);
  REQUIRE(schedule);
  const auto covers = compete_by_schedule(web, environment, *schedule);
  REQUIRE(covers);
  std::vector<CoverMap::Tile> tiles(18);
  std::vector<CoverMap::Tile*> out;
  for (auto& tile : tiles) {
    tile.fill(0);
    out.push_back(&tile);
  }
  const Rect part{67, 65, 92, 81};
  compete_in_tile(web, environment, *schedule, part, out);
  for (std::size_t i = 0; i < 18; ++i) {
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) REQUIRE(tiles[i][CoverMap::offset(x, y)] == (*covers)[i](x, y));
    }
  }
  CHECK(achieved_shares(*covers)[0] == 0);
}

TEST_CASE("A stopped schedule gives nothing") {
  std::stop_source source;
  source.request_stop();
  TaskContext context;
  context.stop = source.get_token();
  const FoodWeb web = plant_scene::web_of({{"a", easy_plant()}});
  CHECK_FALSE(share_schedule(web, Scene(8, 8).environment(), std::vector{1.0}, context));
  CHECK_FALSE(compete_with_proportions(web, Scene(200, 200).environment(), std::vector{1.0}, context));
}
