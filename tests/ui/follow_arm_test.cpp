#include "ui/follow_arm.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/render/sample_plants.hpp"

using namespace biotope;

TEST_CASE("A camera that follows an animal comes nearer while a tree is between, without a jump, and goes back when it is not") {
  const auto maps = test::level_landscape();
  test::cover(*maps, 0, 0.3F);
  const PlantPlacement placement(maps);
  const auto trees = placement.block(Stratum::tree, 2, 2);
  REQUIRE_FALSE(trees.empty());
  const PlantInstance& tree = trees.front();
  const glm::dvec3 foot(double(tree.x), double(tree.y), double(tree.z));
  const PlantShape& shape = maps->web->species[std::size_t(maps->web->levels[0][std::size_t(tree.plant)])].plant().shape;
  const glm::dvec3 crown = foot + glm::dvec3(0, 0, 0.6 * double(shape.height) * double(tree.scale));
  // The animal is beside the trunk, under the crown's edge; the camera is to be among the leaves.
  const glm::dvec3 animal = foot + glm::dvec3(1.5, 0, 1);
  const glm::dvec3 eye = crown + 0.2 * (crown - animal);
  FollowArm arm;
  double before = 1;
  for (int frame = 0; frame < 120; ++frame) {
    const double share = arm.share(placement, animal, eye, 1.0 / 30);
    REQUIRE(share <= before + 1e-9);
    REQUIRE(before - share < 0.15);
    before = share;
  }
  CHECK(before < 0.9);
  // Where nothing grows it is as long as the person made it.
  for (int frame = 0; frame < 300; ++frame) before = arm.share(PlantPlacement(), animal, eye, 1.0 / 30);
  CHECK(before == Approx(1).margin(0.01));
  // Over a whole landscape trees do not count.
  FollowArm far;
  CHECK(far.share(placement, animal, animal + glm::dvec3(200, 0, 120), 1) == 1);
}
