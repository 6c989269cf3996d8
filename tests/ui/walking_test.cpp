#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "render/landscape_renderer.hpp"
#include "ui/walking.hpp"

using namespace biotope;

namespace {

/// 40 x 40 cells of 2 m; heights and depths by metres east and north of the south-west corner.
struct Place {
  Terrain terrain;
  Hydrology water;
  using Shape = std::function<float(double, double)>;

  explicit Place(const Shape& height, const Shape& depth = {}) {
    constexpr int cells = 40;
    terrain.cell_size = 2;
    terrain.height = Grid<float>(cells, cells);
    water.water_depth = Grid<float>(cells, cells);
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) {
        const double east = (x + 0.5) * 2;
        const double north = (cells - y - 0.5) * 2;
        terrain.height(x, y) = height(east, north);
        water.water_depth(x, y) = depth ? depth(east, north) : 0;
      }
    }
  }
  [[nodiscard]] WalkingGround ground() const { return {terrain, &water}; }
};

const auto flat = [](double, double) { return 10.0F; };

}  // namespace

TEST_CASE("on a plain one gets as far as one walks") {
  const Place place(flat);
  const glm::dvec2 end = walked(place.ground(), {20, 20}, {12, 9});
  CHECK(end.x == Approx(32));
  CHECK(end.y == Approx(29));
}

TEST_CASE("a gentle slope is climbed and a wall is not") {
  const Place ramp([](double east, double) { return float(east * 0.6); });
  CHECK(walked(ramp.ground(), {20, 40}, {20, 0}).x == Approx(40));
  const Place wall([](double east, double) { return east > 40 ? 30.0F : 0.0F; });
  const glm::dvec2 stopped = walked(wall.ground(), {20, 40}, {40, 0});
  CHECK(stopped.x < 41);
  CHECK(stopped.x > 37);
}

TEST_CASE("one does not walk off a cliff, but gets off ground that is too steep") {
  const Place cliff([](double east, double) { return east > 40 ? 0.0F : 30.0F; });
  CHECK(walked(cliff.ground(), {20, 40}, {40, 0}).x < 41);
  const Place steep([](double east, double) { return float(-east * 2.2); });
  CHECK(walked(steep.ground(), {20, 40}, {10, 0}).x == Approx(30));
  CHECK(walked(steep.ground(), {40, 40}, {-10, 0}).x == Approx(40));
}

TEST_CASE("along a wall one slides instead of sticking to it") {
  const Place wall([](double east, double) { return east > 40 ? 30.0F : 0.0F; });
  const glm::dvec2 end = walked(wall.ground(), {30, 30}, {20, 20});
  CHECK(end.x < 41);
  CHECK(end.y > 42);
}

TEST_CASE("a brook is waded and a lake is walked around or stops one") {
  const Place brook(flat, [](double east, double) { return east > 38 && east < 46 ? 0.7F : 0.0F; });
  CHECK(walked(brook.ground(), {20, 40}, {40, 0}).x == Approx(60));
  const Place lake(flat, [](double east, double) { return east > 38 ? 3.0F : 0.0F; });
  const glm::dvec2 shore = walked(lake.ground(), {20, 40}, {40, 0});
  CHECK(water_depth(lake.ground(), shore) <= deepest_wading);
  CHECK(shore.x > 36);
}

TEST_CASE("who is in deep water gets out of it") {
  const Place bowl(flat, [](double east, double) { return float(std::max(0.0, 4 - 0.2 * east)); });
  const glm::dvec2 out = walked(bowl.ground(), {2, 40}, {40, 0});
  CHECK(out.x == Approx(42));
}

TEST_CASE("however long the step, nobody jumps over a wall or a river") {
  // One frame of a slow machine: half a second of running.
  const Place wall([](double east, double) { return east > 40 && east < 44 ? 30.0F : 0.0F; });
  CHECK(walked(wall.ground(), {20, 40}, {40, 0}).x < 41);
  const Place river(flat, [](double east, double) { return east > 39 && east < 45 ? 2.5F : 0.0F; });
  CHECK(walked(river.ground(), {20, 40}, {40, 0}).x < 42);
}

TEST_CASE("nobody leaves the land") {
  const Place place(flat);
  for (const glm::dvec2 way : {glm::dvec2(500, 0), glm::dvec2(-500, 3), glm::dvec2(0, 500), glm::dvec2(7, -500)}) {
    const glm::dvec2 end = walked(place.ground(), {40, 40}, way);
    CHECK(end.x >= 0);
    CHECK(end.y >= 0);
    CHECK(end.x <= 80);
    CHECK(end.y <= 80);
  }
}

TEST_CASE("eyes are 1.7 m over the ground, and come there smoothly") {
  const Place step([](double east, double) { return east > 40 ? 10.5F : 10.0F; });
  CHECK(eye_level(step.ground(), {20, 40}) == Approx(11.7));
  Camera camera;
  camera.position = {38, 40, 11.7};
  camera.heading = 90;
  const Camera next = camera_on_foot(step.ground(), camera, 0, 4, 1.0 / 30);
  CHECK(next.position.x == Approx(42));
  CHECK(next.position.z > 11.7);
  CHECK(next.position.z < 12.2);
  Camera rests = next;
  for (int i = 0; i < 60; ++i) rests = camera_on_foot(step.ground(), rests, 0, 0, 1.0 / 30);
  CHECK(rests.position.z == Approx(12.2));
  const Camera still = camera_on_foot(step.ground(), rests, 0, 0, 1.0 / 30);
  CHECK(still.position == rests.position);
}

TEST_CASE("ahead is where the camera looks, right is to its right, whatever its pitch") {
  const Place place(flat);
  Camera camera;
  camera.position = {40, 40, 11.7};
  camera.heading = 90;
  camera.pitch = -40;
  CHECK(camera_on_foot(place.ground(), camera, 0, 3, 0.1).position.x == Approx(43));
  CHECK(camera_on_foot(place.ground(), camera, 3, 0, 0.1).position.y == Approx(37));
}

TEST_CASE("one lands where one can stand") {
  const Place lake(flat, [](double east, double north) { return std::hypot(east - 40, north - 40) < 15 ? 5.0F : 0.0F; });
  const glm::dvec2 at = standing_place(lake.ground(), {40, 40});
  CHECK(water_depth(lake.ground(), at) <= 0.4);
  CHECK(glm::length(at - glm::dvec2(40, 40)) < 24);
  CHECK(standing_place(lake.ground(), {5, 5}) == glm::dvec2(5, 5));
}
