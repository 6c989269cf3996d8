#include "render/plant_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
    CHECK(near.triangles() >= 150);
    CHECK(near.triangles() <= 600);
    CHECK(mid.triangles() >= 35);
    CHECK(mid.triangles() <= 95);
    const PlantExtent extent = extent_of(near);
    CHECK(extent.height == Approx(plant.height).epsilon(0.2));
    CHECK(extent.radius == Approx(0.5 * plant.crown_diameter).epsilon(0.45));
  }
}

TEST_CASE("herbs are a few cards, and every mesh is whole") {
  auto all = shapes();
  for (const char* model : {"grass", "herb", "flower", "something new"}) all.push_back(shape(model, 0.6F, 0.4F, 0.1F));
  for (const PlantShape& plant : all) {
    for (const PlantDetail detail : {PlantDetail::near, PlantDetail::mid}) {
      const PlantMesh mesh = make_plant_mesh(plant, detail, 3);
      INFO(plant.model);
      CHECK(mesh.triangles() > 0);
      if (plant.height < 1) CHECK(mesh.triangles() <= 12);
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

TEST_CASE("leaf pictures have holes, all but bark") {
  const auto pictures = leaf_pictures();
  REQUIRE(pictures.size() == std::size_t(leaf_picture_count));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double covered = 0;
    for (const Rgba& texel : pictures[i].cells()) covered += texel[3] > 0 ? 1 : 0;
    covered /= double(pictures[i].size());
    INFO("picture " << i << " covers " << covered);
    if (LeafPicture(i) == LeafPicture::bark) {
      CHECK(covered == 1);
    } else {
      CHECK(covered > 0.02);
      CHECK(covered < 0.75);
    }
  }
}
