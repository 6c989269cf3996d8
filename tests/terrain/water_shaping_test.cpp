#include "core/terrain/water_shaping.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "core/terrain/ground_tiles.hpp"
#include "core/terrain/shaping.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int side = 320;

DrawnRiver river_from(PathPoint head, float east, float south, double discharge) {
  return {{head, {head.x + 0.5F * east, head.y + 0.3F * south}, {head.x + east, head.y + south}}, discharge};
}

DrawnLake lake_at(float x, float y, float radius) {
  DrawnLake lake;
  for (int i = 0; i < 6; ++i) lake.shore.push_back({x + radius * std::cos(float(i)), y + radius * std::sin(float(i))});
  return lake;
}

/// Ground that is painted and drawn on, followed from edit to edit.
class Followed {
 public:
  Followed() : file_(rough_ground(side, side, 5, 3)), ground_(file_), land_(file_), paint_(side, side) {
    shaping_.lay({}, land_);
  }

  void dab(int x, int y, int radius, float height) {
    for (int cy = std::max(0, y - radius); cy < std::min(side, y + radius + 1); ++cy) {
      for (int cx = std::max(0, x - radius); cx < std::min(side, x + radius + 1); ++cx) paint_.set(cx, cy, {height, 0.7F});
    }
    TileSet changed(side, side);
    changed.insert(Rect{x - radius, y - radius, x + radius + 1, y + radius + 1});
    follow(changed);
  }
  void draw(const DrawnWater& water) {
    water_ = water;
    follow(TileSet(side, side));
  }
  [[nodiscard]] const DrawnWater& water() const { return water_; }
  [[nodiscard]] std::size_t laid() const { return shaping_.laid(); }
  /// Whether the ground is the one that is shaped from scratch, to the bit.
  [[nodiscard]] bool is_scratch() const { return land_.height == shaped_terrain(file_, &paint_, water_).height; }

 private:
  void follow(const TileSet& changed) {
    paint_heights(file_.height, &paint_, file_.height.rect(), ground_.height);
    const Grid<float> before = land_.height;
    const TileSet written = shaping_.follow(ground_, changed, water_, land_);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const bool told = written.contains(std::size_t(y / small_side) * (side / small_side) + std::size_t(x / small_side));
        if (!told && before(x, y) != land_.height(x, y)) FAIL("changed in secret: " << x << ", " << y);
      }
    }
  }

  Terrain file_;
  Terrain ground_;
  Terrain land_;
  PaintLayer paint_;
  DrawnWater water_;
  WaterShaping shaping_;
};

}  // namespace

TEST_CASE("A dab away from drawn water digs and carves nothing again; one on it only what lies there") {
  Followed ground;
  ground.draw({{river_from({20, 20}, 40, 50, 1), river_from({270, 30}, 30, 60, 1)}, {lake_at(60, 260, 20)}});
  CHECK(ground.laid() == 3);
  CHECK(ground.is_scratch());
  ground.dab(240, 280, 12, 120);
  CHECK(ground.laid() == 0);
  CHECK(ground.is_scratch());
  ground.dab(60, 260, 10, 90);
  CHECK(ground.laid() == 1);
  CHECK(ground.is_scratch());
  ground.dab(280, 60, 8, 104);
  CHECK(ground.laid() >= 1);
  CHECK(ground.laid() < 3);
  CHECK(ground.is_scratch());
}

TEST_CASE("One more river leaves the others as they lie, and one that is taken away gives its ground back") {
  Followed ground;
  const DrawnWater two{{river_from({20, 20}, 40, 50, 1)}, {lake_at(60, 260, 20)}};
  ground.draw(two);
  DrawnWater three = two;
  three.rivers.insert(three.rivers.begin(), river_from({270, 30}, 30, 60, 1));
  ground.draw(three);
  CHECK(ground.laid() == 1);
  CHECK(ground.is_scratch());
  ground.draw(two);
  CHECK(ground.laid() == 0);
  CHECK(ground.is_scratch());
  ground.draw({});
  CHECK(ground.is_scratch());
}

TEST_CASE("Drawn water followed over random dabs and lines is that from scratch, to the bit") {
  for (std::uint64_t session = 0; session < 12; ++session) {
    Followed ground;
    for (std::uint64_t step = 0; step < 14; ++step) {
      const auto chance = [&](int low, int high, std::uint64_t what) { return random_int(low, high, {session, step, what}); };
      DrawnWater water = ground.water();
      const int kind = chance(0, 6, 1);
      const PathPoint place{float(chance(0, side, 2)), float(chance(0, side, 3))};
      if (kind == 0) {
        const auto at = water.rivers.begin() + chance(0, int(water.rivers.size()), 4);
        water.rivers.insert(at, river_from(place, float(chance(-140, 140, 5)), float(chance(-140, 140, 6)), chance(1, 40, 7)));
      } else if (kind == 1) {
        water.lakes.push_back(lake_at(place.x, place.y, float(chance(5, 50, 5))));
      } else if (kind == 2 && !water.rivers.empty()) {
        std::swap(water.rivers.front(), water.rivers.back());
        if (chance(0, 1, 8) == 0) water.rivers.pop_back();
      } else if (kind == 3 && !water.lakes.empty()) {
        water.lakes.erase(water.lakes.begin());
      }
      INFO("session " << session << ", step " << step << ", kind " << kind);
      if (water == ground.water()) {
        ground.dab(int(place.x), int(place.y), chance(2, 40, 9), float(chance(60, 160, 10)));
      } else {
        ground.draw(water);
      }
      REQUIRE(ground.is_scratch());
    }
  }
}
