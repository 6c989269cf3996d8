#include <catch2/catch.hpp>

#include "core/exchange/document_scale.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;

TEST_CASE("A coarser document keeps its paint, selection and placements where they were on the ground") {
  Document document = full_document();
  const Terrain& terrain = *document.terrain;
  PaintLayer geology(terrain.height.width(), terrain.height.height());
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) geology.set(x, y, {x < 32 ? 1.0F : 4.0F, 1});
  }
  document.layers[{LayerKind::geology, "class"}] = std::make_shared<const PaintLayer>(geology);
  SelectionMask selection(terrain.height.width(), terrain.height.height());
  for (int y = 0; y < 10; ++y) {
    for (int x = 20; x < 40; ++x) selection.set(x, y, 200);
  }
  document.selection = std::make_shared<const SelectionMask>(selection);
  document.locked_area = document.selection;
  document.placements.places.fords = {{{10.5F, 20.5F}, 12}};

  const Document half = resampled_document(document, 80);
  REQUIRE(half.terrain->height.width() == 80);
  const PaintLayer& classes = *half.layers.at({LayerKind::geology, "class"});
  for (int x = 0; x < 32; ++x) CHECK(classes(x, 5) == Paint{x < 16 ? 1.0F : 4.0F, 1});
  CHECK(classes(33, 5) == Paint{});
  REQUIRE(half.selection);
  REQUIRE(half.locked_area);
  CHECK(half.locked_area->to_grid() == half.selection->to_grid());
  CHECK(half.selection->width() == 80);
  CHECK((*half.selection)(12, 2) == 200);
  CHECK((*half.selection)(5, 2) == 0);
  // Between cells 10 and 11 lies the centre of the halved cell 5.
  CHECK(half.placements.places.fords.front().at == PathPoint{5, 10});
  CHECK(half.placements.places.fords.front().radius == 12);
  CHECK(half.layer_states == document.layer_states);
  CHECK(half.placements.plans.front().stops.size() == document.placements.plans.front().stops.size());
}

TEST_CASE("Larger cells under the same map make placed things as much larger") {
  Document document = full_document();
  document.placements.places.fords = {{{10, 20}, 12}};
  document.placements.water.rivers = {{{{1, 1}, {2, 2}}, 3}};
  const Document wide = with_cell_size(document, document.terrain->cell_size * 2);
  CHECK(wide.placements.places.fords.front().radius == 24);
  CHECK(wide.placements.places.fords.front().at == PathPoint{10, 20});
  CHECK(wide.placements.water.rivers.front().discharge == 12);
}
