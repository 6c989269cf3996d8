#include <catch2/catch.hpp>

#include "render/landscape_renderer.hpp"
#include "tests/ui/small_landscape.hpp"
#include "ui/camera_motion.hpp"

using namespace biotope;

namespace {
const PixelPoint canvas{800, 600};
}

TEST_CASE("the ray through the middle of the canvas is where the camera looks") {
  Camera camera;
  camera.heading = 70;
  camera.pitch = -25;
  const glm::vec3 ray = ray_through(camera, canvas, {400, 300});
  CHECK(glm::dot(ray, camera.forward()) == Approx(1).margin(1e-5));
  CHECK(glm::dot(ray_through(camera, canvas, {700, 300}), camera.right()) > 0);
  CHECK(ray_through(camera, canvas, {400, 100}).z > ray.z);
}

TEST_CASE("an orbit keeps its distance and what it turns around in the middle") {
  Camera camera;
  camera.position = {0, -100, 100};
  camera.heading = 0;
  camera.pitch = -45;
  const glm::dvec3 around{0, 0, 0};
  const Camera next = orbited(camera, around, 40, -10);
  CHECK(glm::length(next.position) == Approx(glm::length(camera.position)));
  const glm::dvec3 toward = glm::normalize(around - next.position);
  CHECK(glm::dot(toward, glm::dvec3(next.forward())) == Approx(1).margin(1e-4));
}

TEST_CASE("looking around never turns upside down") {
  Camera camera;
  camera = turned(camera, 0, 500);
  CHECK(camera.pitch < 90);
  camera = turned(camera, -400, -500);
  CHECK(camera.pitch > -90);
  CHECK(camera.heading >= 0);
  CHECK(camera.heading < 360);
}

TEST_CASE("the camera stays above the ground and near the landscape") {
  const auto snapshot = small_landscape();
  const Terrain& terrain = snapshot->terrain();
  Camera camera;
  camera.position = {350, 300, -1000};
  CHECK(kept_over_ground(camera, terrain).position.z == Approx(ground_height(terrain, 350, 300) + 1.5));
  // A lake that came to lie there lifts it over its surface.
  Hydrology lake;
  lake.water_depth = Grid<float>(terrain.height.width(), terrain.height.height(), 7);
  CHECK(kept_over_ground(camera, terrain, 1.5, &lake).position.z == Approx(ground_height(terrain, 350, 300) + 8.5));
  camera.position = {1e9, -1e9, 1e9};
  const Camera kept = kept_over_ground(camera, terrain);
  CHECK(kept.position.x < 1e4);
  CHECK(kept.position.y > -1e4);
}

TEST_CASE("metres and cells agree: the north-west cell's centre is half a cell from the corner") {
  const auto snapshot = small_landscape();
  const PathPoint cell = cell_of(snapshot->terrain(), {5, 655, 0});
  CHECK(cell.x == Approx(0));
  CHECK(cell.y == Approx(0));
}
