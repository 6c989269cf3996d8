#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/base/random.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Grass and bushes in two valleys, with deer that fear dense trees, goats and wolves.
struct Valleys {
  WebBuilder builder;
  Ground ground;
  std::vector<std::shared_ptr<const CoverMap>> plants;

  Valleys() {
    const int grass = builder.plant("grass", 0.1F);
    const int bushes = builder.plant("bushes", 0.05F, Stratum::shrub);
    AnimalTraits goat = walker(2, 8);
    goat.max_slope = 1.5F;
    goat.max_tree_cover = 0.9F;
    const int deer = builder.animal("deer", 1, walker(5, 12), {{"fodder", {grass, bushes}, 2}});
    const int goats = builder.animal("goat", 1, goat, {{"fodder", {grass}, 1}});
    builder.animal("wolf", 2, walker(1), {{"meat", {deer, goats}, 1}});
    Landscape land(130, 90, 50);
    land.cliff_column(60, 1);
    land.brook_row(40);
    ground = land.ground();
    plants = {cover(1), cover(2)};
  }
  [[nodiscard]] static std::shared_ptr<const CoverMap> cover(std::uint64_t seed) {
    Grid<Cover> grid(130, 90);
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = Cover(random_int(0, full_cover, {seed, i / 29}));
    return std::make_shared<const CoverMap>(tiled(grid));
  }
  /// Both levels; `previous` may be empty.
  [[nodiscard]] std::vector<std::shared_ptr<const AnimalLevel>> solve(
      const std::vector<std::shared_ptr<const AnimalLevel>>& previous,
      const std::vector<std::shared_ptr<const PaintLayer>>& paint = {}) const {
    std::vector<std::shared_ptr<const AnimalLevel>> levels;
    for (const int level : {1, 2}) {
      AnimalLevelInput input{builder.web, level, ground, plants, levels, {}, {}, {}, 1};
      if (level == 1) input.paint = paint;
      if (!previous.empty()) input.previous = previous[std::size_t(level) - 1];
      auto result = compute_animal_level(input);
      REQUIRE(result);
      levels.push_back(std::make_shared<const AnimalLevel>(std::move(*result)));
    }
    return levels;
  }
};

void plant_trees(Ground& ground, const Rect& rect, Cover cover) {
  Grid<Cover> trees = *ground.tree_cover;
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) trees(x, y) = cover;
  }
  ground.tree_cover = std::make_shared<const Grid<Cover>>(std::move(trees));
}

void check_same(const std::vector<std::shared_ptr<const AnimalLevel>>& a,
                const std::vector<std::shared_ptr<const AnimalLevel>>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(same_level(*a[i], *b[i]));
}

}  // namespace

TEST_CASE("plants that change where nobody's way is barred leave regions, partition and banks as they were") {
  Valleys valleys;
  const auto before = valleys.solve({});
  valleys.plants[0] = Valleys::cover(3);
  plant_trees(valleys.ground, {10, 10, 30, 30}, full_cover / 2);
  const auto after = valleys.solve(before);
  check_same(after, valleys.solve({}));
  CHECK(after[0]->population != before[0]->population);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(after[i]->regions == before[i]->regions);
    CHECK(after[i]->partition == before[i]->partition);
    CHECK(after[i]->basis.banks == before[i]->basis.banks);
    CHECK(after[i]->graph != before[i]->graph);
  }
}

TEST_CASE("trees that bar the way of some make new regions for them alone") {
  Valleys valleys;
  const auto before = valleys.solve({});
  plant_trees(valleys.ground, {0, 20, 130, 22}, 2 * full_cover / 3);
  const auto after = valleys.solve(before);
  check_same(after, valleys.solve({}));
  CHECK(after[0]->regions[0]->regions.size() > before[0]->regions[0]->regions.size());
  CHECK(after[0]->regions[1] == before[0]->regions[1]);
  CHECK(after[0]->partition != before[0]->partition);
}

TEST_CASE("paint on animals leaves the nodes of their level as they were") {
  Valleys valleys;
  const auto before = valleys.solve({});
  const std::vector<std::shared_ptr<const PaintLayer>> paint{paint_rect(130, 90, {5, 5, 25, 25}, 0), nullptr};
  const auto after = valleys.solve(before, paint);
  check_same(after, valleys.solve({}, paint));
  CHECK(after[0]->graph == before[0]->graph);
  CHECK(after[0]->population != before[0]->population);
  CHECK(after[1]->partition == before[1]->partition);
}
