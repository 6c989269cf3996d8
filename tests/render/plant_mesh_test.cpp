#include "render/plant_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "render/plant_branches.hpp"
#include "render/plant_leaves.hpp"

using namespace biotope;

namespace {

PlantShape shape(const std::string& model, float height, float crown, float trunk) {
  PlantShape out;
  out.model = model;
  out.height = height;
  out.crown_diameter = crown;
  out.trunk_fraction = trunk;
  return out;
}

const std::vector<PlantShape>& shapes() {
  static const std::vector<PlantShape> all{shape("broadleaf", 16, 12, 0.25F),
                                           shape("evergreen-oak", 12, 9, 0.2F),
                                           shape("alder", 18, 8, 0.2F),
                                           shape("birch", 16, 6, 0.3F),
                                           shape("conifer", 17, 7, 0.45F),
                                           shape("conifer", 24, 6, 0.08F),
                                           shape("mountain-pine", 3.5F, 3.8F, 0.05F),
                                           shape("juniper", 4, 1.8F, 0.05F),
                                           shape("shrub", 2.5F, 2.5F, 0.05F)};
  return all;
}

}  // namespace

TEST_CASE("woody plants stay within their budget of triangles and near their shape's size") {
  for (const PlantShape& plant : shapes()) {
    INFO(plant.model << " " << plant.height);
    const PlantMesh near = make_plant_mesh(plant, PlantDetail::near, 1);
    const PlantMesh mid = make_plant_mesh(plant, PlantDetail::mid, 1);
    const PlantMesh close = make_plant_mesh(plant, PlantDetail::close, 1);
    CHECK(close.triangles() >= 1200);
    CHECK(close.triangles() <= 9000);
    CHECK(close.vertices.size() < 65536);
    CHECK(extent_of(close).height == Approx(extent_of(near).height).epsilon(0.2));
    CHECK(extent_of(close).radius == Approx(extent_of(near).radius).epsilon(0.3));
    CHECK(near.triangles() >= 280);
    CHECK(near.triangles() <= 2200);
    CHECK(mid.triangles() >= 35);
    CHECK(mid.triangles() <= 175);
    const PlantExtent extent = extent_of(near);
    CHECK(extent.height == Approx(plant.height).epsilon(0.2));
    CHECK(extent.radius == Approx(0.5 * plant.crown_diameter).epsilon(0.52));
  }
}

TEST_CASE("herbs near are single blades, from afar two cards, and every mesh is whole") {
  auto all = shapes();
  for (const char* model : {"grass", "herb", "flower", "something new"}) all.push_back(shape(model, 0.6F, 0.4F, 0.1F));
  for (const PlantShape& plant : all) {
    for (const PlantDetail detail : {PlantDetail::close, PlantDetail::near, PlantDetail::mid}) {
      const PlantMesh mesh = make_plant_mesh(plant, detail, 3);
      INFO(plant.model);
      CHECK(mesh.triangles() > 0);
      if (plant.height < 1) CHECK(mesh.triangles() <= (detail == PlantDetail::mid ? 8U : 70U));
      for (const auto index : mesh.indices) REQUIRE(index < mesh.vertices.size());
      for (const PlantVertex& vertex : mesh.vertices) {
        REQUIRE(glm::length(vertex.normal) == Approx(1).epsilon(1e-3));
        REQUIRE(vertex.open >= 0);
        REQUIRE(vertex.open <= 1);
        REQUIRE(std::isfinite(vertex.position.x + vertex.position.y + vertex.position.z));
      }
    }
  }
}

TEST_CASE("a crown is darker inside and below than on its top") {
  const PlantMesh oak = make_plant_mesh(shapes()[0], PlantDetail::near, 1);
  float top = 0;
  float low = 0;
  int tops = 0;
  int lows = 0;
  for (const PlantVertex& vertex : oak.vertices) {
    if (vertex.leaf < 0.5F) continue;
    if (vertex.position.z > 13) top += vertex.open, ++tops;
    if (vertex.position.z < 7) low += vertex.open, ++lows;
  }
  REQUIRE(tops > 0);
  REQUIRE(lows > 0);
  CHECK(top / float(tops) > 1.4F * low / float(lows));
}

TEST_CASE("leaf pictures have holes, all but barks") {
  const auto pictures = leaf_pictures();
  REQUIRE(pictures.size() == std::size_t(leaf_picture_count));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double covered = 0;
    for (const Rgba& texel : pictures[i].cells()) covered += texel[3] > 0 ? 1 : 0;
    covered /= double(pictures[i].size());
    INFO("picture " << i << " covers " << covered);
    if (is_solid(LeafPicture(i))) {
      CHECK(covered == 1);
    } else {
      CHECK(covered > 0.02);
      CHECK(covered < 0.75);
    }
  }
}

TEST_CASE("cards are cut to what their pictures show") {
  const auto pictures = leaf_pictures();
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const CardBox box = card_box(LeafPicture(i));
    int outside = 0;
    for (int y = 0; y < leaf_picture_side; ++y) {
      for (int x = 0; x < leaf_picture_side; ++x) {
        if (pictures[i](x, y)[3] < 128) continue;
        const glm::vec2 at = (glm::vec2(x, y) + 0.5F) / float(leaf_picture_side);
        outside += at.x < box.low.x || at.y < box.low.y || at.x > box.high.x || at.y > box.high.y ? 1 : 0;
      }
    }
    INFO("picture " << i);
    CHECK(outside == 0);
  }
}

TEST_CASE("foliage does not thin out with distance") {
  const auto pictures = leaf_pictures();
  for (const LeafPicture which : {LeafPicture::broad, LeafPicture::small, LeafPicture::needles, LeafPicture::bough,
                                  LeafPicture::blades, LeafPicture::oak_spray, LeafPicture::pine_spray, LeafPicture::frond}) {
    const auto levels = leaf_mipmaps(which, pictures[std::size_t(which)]);
    REQUIRE(levels.back().width() == 4);
    const auto passing = [](const Grid<Rgba>& level) {
      double count = 0;
      for (const Rgba& texel : level.cells()) count += texel[3] >= 128 ? 1 : 0;
      return count / double(level.size());
    };
    for (std::size_t level = 1; level + 2 < levels.size(); ++level) {
      INFO("picture " << int(which) << " level " << level);
      // The first levels have only a few different values to choose from.
      CHECK(passing(levels[level]) == Approx(passing(levels[0])).margin(level < 3 ? 0.1 : 0.05));
    }
  }
}

TEST_CASE("bare twigs stay lines from afar: neither dots nor a hedge") {
  const auto pictures = leaf_pictures();
  const auto levels = leaf_mipmaps(LeafPicture::twigs, pictures[std::size_t(LeafPicture::twigs)]);
  REQUIRE(levels.back().width() == 4);
  for (std::size_t level = 0; level + 2 < levels.size(); ++level) {
    const Grid<Rgba>& picture = levels[level];
    double covered = 0;
    double alone = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        if (picture(x, y)[3] < 128) continue;
        ++covered;
        int beside = 0;
        for (int i = 0; i < 9; ++i) {
          const int cx = std::clamp(x + i % 3 - 1, 0, picture.width() - 1);
          const int cy = std::clamp(y + i / 3 - 1, 0, picture.height() - 1);
          beside += i != 4 && picture(cx, cy)[3] >= 128 ? 1 : 0;
        }
        alone += beside == 0 ? 1 : 0;
      }
    }
    INFO("level " << level << " covers " << covered / double(picture.size()));
    CHECK(covered > 0.03 * double(picture.size()));
    CHECK(covered < 0.30 * double(picture.size()));
    CHECK(alone < 0.05 * covered);
  }
}

TEST_CASE("a branch is as thick as all that it carries, and limbs turn by the golden angle") {
  BranchingHabit habit;
  habit.wander = 0;
  habit.limbs = 8;
  MeshRandom random(5);
  const PlantShape plant = shape("broadleaf", 16, 12, 0.25F);
  const Branching oak = grow_branches(plant, habit, random);
  const auto of_order = [&](int order) {
    std::vector<const Branch*> out;
    for (const Branch& branch : oak.branches) {
      if (branch.order == order) out.push_back(&branch);
    }
    return out;
  };
  REQUIRE(of_order(0).size() == 1);
  REQUIRE(of_order(1).size() == 8);
  CHECK(of_order(2).size() == std::size_t(8 * habit.shoots));
  CHECK(of_order(3).size() == std::size_t(8 * habit.shoots * habit.twigs));
  for (const Branch& branch : oak.branches) {
    for (std::size_t i = 1; i < branch.radii.size(); ++i) CHECK(branch.radii[i] <= branch.radii[i - 1]);
  }
  // Cross sections of the limbs add up to the trunk's (its foot spreads by 1.45).
  float limbs = 0;
  for (const Branch* limb : of_order(1)) limbs += limb->radii.front() * limb->radii.front();
  const float trunk = of_order(0)[0]->radii.front() / 1.45F;
  CHECK(limbs == Approx(trunk * trunk).epsilon(0.02));
  for (const Branch* limb : of_order(1)) CHECK(limb->radii.front() > 2 * of_order(3)[0]->radii.front());
  const auto turn = [&](std::size_t i) {
    const glm::vec3 along = of_order(1)[i]->points[1] - of_order(1)[i]->points[0];
    return std::atan2(along.y, along.x);
  };
  for (std::size_t i = 1; i < 8; ++i) {
    // Each limb strays by up to 0.3.
    const float step = std::remainder(turn(i) - turn(i - 1) - 2.39996F, 6.28319F);
    CHECK(std::abs(step) <= 0.61F);
  }
}

TEST_CASE("the same tree far as near, and two models of a kind differ") {
  for (const PlantShape& plant : shapes()) {
    INFO(plant.model);
    const PlantExtent near = extent_of(make_plant_mesh(plant, PlantDetail::near, 9));
    const PlantExtent mid = extent_of(make_plant_mesh(plant, PlantDetail::mid, 9));
    CHECK(mid.height == Approx(near.height).epsilon(0.2));
    CHECK(mid.radius == Approx(near.radius).epsilon(0.42));
    const PlantMesh one = make_plant_mesh(plant, PlantDetail::near, 9);
    const PlantMesh same = make_plant_mesh(plant, PlantDetail::near, 9);
    const PlantMesh other = make_plant_mesh(plant, PlantDetail::near, 10);
    const auto equal = [](const PlantMesh& a, const PlantMesh& b) {
      return a.vertices.size() == b.vertices.size() &&
             std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                        [](const PlantVertex& u, const PlantVertex& v) { return u.position == v.position; });
    };
    CHECK(equal(one, same));
    CHECK_FALSE(equal(one, other));
  }
}

TEST_CASE("species are told apart by their shape") {
  const auto width_at = [](const PlantMesh& mesh, float low, float high) {
    float widest = 0;
    for (const PlantVertex& vertex : mesh.vertices) {
      if (vertex.position.z >= low && vertex.position.z < high) {
        widest = std::max(widest, std::hypot(vertex.position.x, vertex.position.y));
      }
    }
    return widest;
  };
  const auto of = [](const PlantShape& plant) { return make_plant_mesh(plant, PlantDetail::near, 2); };
  const PlantMesh oak = of(shapes()[0]);
  const PlantMesh alder = of(shapes()[2]);
  const PlantMesh pine = of(shapes()[4]);
  const PlantMesh spruce = of(shapes()[5]);
  const PlantMesh mugo = of(shapes()[6]);
  // An oak is wide, an alder narrow.
  CHECK(extent_of(oak).radius / extent_of(oak).height > 1.35F * extent_of(alder).radius / extent_of(alder).height);
  // A spruce tapers from its foot to a point; a pine bears its crown high.
  CHECK(width_at(spruce, 0.5F, 8) > 3 * width_at(spruce, 19, 25));
  CHECK(width_at(pine, 0.5F, 6) < 0.3F * width_at(pine, 10, 16));
  // A mountain pine is wide at the ground.
  CHECK(width_at(mugo, 0, 1) > 0.6F * extent_of(mugo).radius);
}
