#include "core/ecosystem/herd_surplus.hpp"

#include "animal_scene.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Two meadows parted by a cliff, with deer on both and wolves that hunt only on the western one.
struct TwoMeadows {
  int grass = 0;
  int deer = 0;
  Scene scene;

  /// `deer_per_km2`: paint on the deer of the eastern meadow; negative for none.
  explicit TwoMeadows(float deer_per_km2 = -1) : scene(land(), web(grass, deer)) {
    std::vector<std::shared_ptr<const PaintLayer>> on_deer;
    if (deer_per_km2 >= 0) on_deer = {paint_rect(41, 20, {21, 0, 41, 20}, deer_per_km2)};
    scene.levels.push_back(scene.solve(1, {}, on_deer));
    scene.levels.push_back(scene.solve(2, {}, {paint_rect(41, 20, {21, 0, 41, 20}, 0)}));
  }
  static Landscape land() {
    Landscape land(41, 20);
    land.cliff_column(20);
    land.brook_row(5);
    land.hydrology.discharge(20, 5) = 0;
    return land;
  }
  static FoodWeb web(int& grass, int& deer) {
    WebBuilder builder;
    grass = builder.plant("grass", 0.1F);
    deer = builder.animal("deer", 1, walker(10), {{"grass", {grass}, 1}});
    builder.animal("wolf", 2, walker(1), {{"meat", {deer}, 1}});
    return std::move(builder.web);
  }
  [[nodiscard]] HerdSurplus in(int region) const {
    return herd_surplus(scene.web, scene.levels, *scene.levels[0], {deer, region, 10});
  }
  [[nodiscard]] double young_in(int region) const {
    return young_share(scene.web.species[std::size_t(deer)].animal(), in(region));
  }
};

}  // namespace

TEST_CASE("where a herd is hunted fewer of its young are left than where it is not") {
  const TwoMeadows meadows;
  REQUIRE(meadows.scene.levels[1]->population[0][0] > 0);
  REQUIRE(meadows.scene.levels[1]->population[0][1] == 0);
  const HerdSurplus hunted = meadows.in(0);
  const HerdSurplus free = meadows.in(1);
  // Of 20 % of the deer, 100 kg each, every wolf eats 365 kg a year.
  const double deer = meadows.scene.levels[0]->population[0][0];
  const double wolves = meadows.scene.levels[1]->population[0][0];
  CHECK(hunted.own == Approx(1 - wolves * 365 / (deer * 0.2 * 100)).margin(1e-6));
  CHECK(free.own == 1);
  CHECK(hunted.food == Approx(free.food).margin(0.02));
  CHECK(meadows.young_in(0) < 0.5 * meadows.young_in(1));
  CHECK(meadows.young_in(0) > 0);
}

TEST_CASE("a herd with more food to spare has more young") {
  const TwoMeadows full;
  const TwoMeadows sparse(40);
  REQUIRE(sparse.scene.levels[0]->population[0][1] < 0.5 * full.scene.levels[0]->population[0][1]);
  CHECK(full.in(1).food < 0.05);
  CHECK(sparse.in(1).food > 0.4);
  CHECK(sparse.young_in(1) > 1.5 * full.young_in(1));
  // All that are born of the others: 0.2 a head.
  CHECK(young_share(full.scene.web.species[std::size_t(full.deer)].animal(), {1, 1}) == Approx(0.2 / 1.2));
}

TEST_CASE("growth that is lost to disease leaves no young") {
  TwoMeadows meadows;
  AnimalLevel level = *meadows.scene.levels[0];
  level.basis.losses = {nullptr, paint_rect(41, 20, {0, 0, 41, 20}, 1), nullptr};
  CHECK(herd_surplus(meadows.scene.web, {}, level, {meadows.deer, 1, 10}).own == 0);
}
