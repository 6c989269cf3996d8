#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "render/animal_mesh.hpp"
#include "render/animal_pick.hpp"
#include "render/animal_season.hpp"
#include "render/animal_surroundings.hpp"

using namespace biotope;

namespace {

struct Listed {
  const char* name;
  const char* model;
  const char* headgear;
  float shoulder;
  float length;
};
constexpr Listed listed[] = {
    {"Bison priscus", "bovid", "horns", 1.8F, 2.9F},         {"Cervus elaphus", "deer", "antlers", 1.25F, 2.1F},
    {"Dama roberti", "deer", "palmate", 0.9F, 1.5F},         {"Rangifer tarandus", "deer", "antlers", 1.15F, 1.9F},
    {"Equus mosbachensis", "horse", "none", 1.5F, 2.4F},     {"Hemitragus bonali", "goat", "horns", 0.9F, 1.3F},
    {"Ovis ammon", "sheep", "curled", 1.1F, 1.7F},           {"Ursus arctos", "bear", "none", 1.1F, 2.0F},
    {"Lynx spelaeus", "cat", "none", 0.65F, 1.0F},           {"Canis mosbachensis", "wolf", "none", 0.7F, 1.2F},
    {"Vulpes vulpes", "fox", "none", 0.38F, 0.7F},           {"Sus scrofa", "boar", "none", 0.9F, 1.5F},
    {"Stephanorhinus sp.", "rhino", "horns", 1.7F, 3.6F},    {"Alces alces", "deer", "palmate", 1.9F, 2.8F},
    {"Odocoileus hemionus", "deer", "antlers", 0.95F, 1.6F}, {"Antilocapra americana", "goat", "horns", 0.9F, 1.4F},
    {"Panthera spelaea", "cat", "none", 1.2F, 2.4F},         {"Unheard of", "unheard-of", "none", 1.2F, 2.0F}};

AnimalShape shape_of(const Listed& one) {
  AnimalShape shape;
  shape.model = one.model;
  shape.headgear = one.headgear;
  shape.shoulder_height = one.shoulder;
  shape.body_length = one.length;
  return shape;
}

}  // namespace

TEST_CASE("Every species has a mesh at every detail, fewer triangles the coarser, on the ground and as tall as it should be") {
  for (const Listed& one : listed) {
    INFO(one.name);
    const AnimalShape shape = shape_of(one);
    std::size_t last = 2200;
    for (const AnimalDetail detail : {AnimalDetail::fine, AnimalDetail::plain, AnimalDetail::silhouette}) {
      const AnimalMesh mesh = make_animal_mesh(shape, one.name, detail);
      CHECK(mesh.indices.size() / 3 < last);
      last = mesh.indices.size() / 3;
      float lowest = 10;
      float withers = 0;
      float longest = 0;
      for (const AnimalVertex& vertex : mesh.vertices) {
        lowest = std::min(lowest, vertex.position.z);
        if (vertex.rig.x == 0 && vertex.rig.y == 0) withers = std::max(withers, vertex.position.z);
        longest = std::max(longest, std::abs(vertex.position.x));
        REQUIRE(std::isfinite(vertex.position.x + vertex.position.y + vertex.position.z));
        REQUIRE(glm::length(vertex.normal) == Approx(1).margin(1e-3));
      }
      CHECK(lowest == Approx(0).margin(0.05 * double(one.shoulder)));
      CHECK(withers > 0.85F * one.shoulder);
      CHECK(withers < 1.25F * one.shoulder);
      CHECK(longest < 1.2F * one.length);
      for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.vertices.size());
    }
    CHECK(last <= 160);
  }
}

TEST_CASE("From afar one still sees what has antlers or horns, and a long tail") {
  const auto reach = [](const Listed& one, float part) {
    float highest = 0;
    const AnimalMesh mesh = make_animal_mesh(shape_of(one), one.name, AnimalDetail::silhouette);
    for (const AnimalVertex& vertex : mesh.vertices) {
      if (vertex.rig.x == part) highest = std::max(highest, std::abs(vertex.position.z) + std::abs(vertex.position.x));
    }
    return highest;
  };
  for (const Listed& one : listed) {
    INFO(one.name);
    const AnimalBuild build = animal_build(shape_of(one), one.name);
    CHECK((reach(one, 7) > one.shoulder) == (build.headgear != Headgear::none));
    CHECK((reach(one, 5) > 0) == (build.tail_length >= 0.3F));
  }
}

TEST_CASE("Deer cast their antlers, grow them in velvet and clean them when their species does") {
  const auto grown = [](const char* name, bool male, int month) { return antlers(name, male, month, 0).grown; };
  // Red deer: clean from September to March, cast by April, in velvet in summer (January is 0).
  for (const int month : {8, 9, 10, 11, 0, 1, 2}) {
    CHECK(grown("Cervus elaphus", true, month) == 1);
    CHECK(!antlers("Cervus elaphus", true, month, 0).velvet);
  }
  CHECK(grown("Cervus elaphus", true, 3) < 0.2F);
  for (const int month : {4, 5, 6}) CHECK(antlers("Cervus elaphus", true, month, 0).velvet);
  for (int month = 4; month < 7; ++month) CHECK(grown("Cervus elaphus", true, month) < grown("Cervus elaphus", true, month + 1));
  // Fallow deer keep theirs a month longer; roe deer grow theirs in winter.
  CHECK(grown("Dama roberti", true, 3) == 1);
  CHECK(antlers("Capreolus capreolus", true, 0, 0).velvet);
  CHECK(!antlers("Capreolus capreolus", true, 6, 0).velvet);
  // In winter reindeer cows have theirs when bulls have none.
  CHECK(grown("Rangifer tarandus", false, 1) == 1);
  CHECK(grown("Rangifer tarandus", true, 1) == 0);
  // Horns stay.
  for (int month = 0; month < 12; ++month) CHECK(grown("Ovis ammon", true, month) == 1);
  // Within the month of casting some have theirs and some have none, but none a half.
  for (const float early : {0.0F, 0.4F, 0.6F, 1.0F}) {
    const float size = antlers("Cervus elaphus", true, 2, early).grown;
    CHECK((size == 1 || size < 0.2F));
  }
  CHECK(antlers("Cervus elaphus", true, 2, 0).grown != antlers("Cervus elaphus", true, 2, 1).grown);
}

TEST_CASE("Coats are thicker and duller in winter, fallow deer lose their spots, and summer's are those of the species") {
  for (const Listed& one : listed) {
    INFO(one.name);
    const AnimalCoat summer = animal_coat(one.name, 6);
    CHECK(summer.grey == 0);
    CHECK(summer.pale == 0);
    CHECK(summer.shade == 1);
    CHECK(summer.hair == 0);
    const AnimalCoat winter = animal_coat(one.name, 0);
    CHECK(winter.hair >= animal_coat(one.name, 9).hair);
    CHECK(winter.hair < 0.05F);
    CHECK(winter.shade <= 1);
  }
  CHECK(animal_coat("Dama roberti", 6).spots == 1);
  CHECK(animal_coat("Dama roberti", 0).spots < 0.2F);
  CHECK(animal_coat("Rangifer tarandus", 0).pale > 0.2F);
  CHECK(northern_month(0, 45) == 0);
  CHECK(northern_month(0, -33) == 6);
  CHECK(northern_month(9, -33) == 3);
}

TEST_CASE("A grazing animal's mouth reaches the ground") {
  for (const Listed& one : listed) {
    INFO(one.name);
    const AnimalShape shape = shape_of(one);
    const AnimalSkeleton skeleton = animal_skeleton(shape, animal_build(shape, one.name));
    CHECK(grazing_muzzle(skeleton, 0).z > 0.15F * one.shoulder);
    CHECK(grazing_muzzle(skeleton, 1).z < 0.06F * one.shoulder);
    CHECK(grazing_muzzle(skeleton, 1).z > -0.06F * one.shoulder);
    // Legs are long enough to stand on, and bent so that they know which way to fold.
    for (const AnimalLeg& leg : skeleton.legs) {
      const float reach = glm::length(leg.knee - leg.hip) + glm::length(leg.foot - leg.knee);
      CHECK(reach > glm::length(leg.foot - leg.hip));
      CHECK(leg.hip.z > leg.knee.z);
    }
  }
}

TEST_CASE("Deer differ by their genus, and a person's word on headgear counts") {
  AnimalShape shape;
  shape.model = "deer";
  shape.headgear = "antlers";
  CHECK(animal_build(shape, "Cervus elaphus").headgear == Headgear::red_antlers);
  CHECK(animal_build(shape, "Rangifer tarandus").headgear == Headgear::caribou_antlers);
  shape.headgear = "palmate";
  CHECK(animal_build(shape, "Dama dama").headgear == Headgear::palmate_antlers);
  shape.headgear = "none";
  CHECK(animal_build(shape, "Cervus elaphus").headgear == Headgear::none);
}

TEST_CASE("A ray finds the animal it hits, the nearest of two, none behind the ground and none behind the eye") {
  AnimalAt near;
  near.plan = 1;
  near.place = {0, 20, 0};
  near.height = 1;
  near.length = 1.6F;
  AnimalAt far = near;
  far.plan = 2;
  far.place = {0.3, 60, 0};
  const std::vector<AnimalAt> drawn{far, near};
  const glm::dvec3 eye(0, 0, 1.7);
  const auto toward = [&](glm::dvec3 place) { return glm::vec3(place + glm::dvec3(0, 0, 0.6) - eye); };
  REQUIRE(pick_animal(drawn, eye, toward(near.place)));
  CHECK(pick_animal(drawn, eye, toward(near.place))->plan == 1);
  CHECK(!pick_animal(drawn, eye, toward(near.place), 10));
  CHECK(!pick_animal(drawn, eye, -toward(near.place)));
  CHECK(!pick_animal(drawn, eye, toward({15, 20, 0})));
  // One that is farther off is hit within a few pixels of its own size.
  CHECK(pick_animal(std::span(&far, 1), eye, toward({0.7, 60, 0})));
  REQUIRE(animal_near(drawn, {0.2, 55}, 10));
  CHECK(animal_near(drawn, {0.2, 55}, 10)->plan == 2);
  CHECK(!animal_near(drawn, {0.2, 45}, 10));
}
