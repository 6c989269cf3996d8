#include <catch2/catch.hpp>
#include <string>

#include "core/document/brush.hpp"
#include "core/pipeline/solve.hpp"
#include "tests/render/studio.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

using Maps = std::shared_ptr<const MapsSnapshot>;

/// The small valley with only the first `animals` of its plant eaters: another number of herds for each.
Maps valley_with(int animals) {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(document);
  const auto layout = Grid<float>(160, 128, 100.0F);
  auto web = build_food_web(*document->species);
  REQUIRE(web);
  const auto& level = web->levels[1];
  for (std::size_t i = std::size_t(animals); i < level.size(); ++i) {
    Stroke stroke({LayerKind::animal_density, web->species[std::size_t(level[i])].name}, &layout);
    stroke.dab(*document, {.mode = BrushMode::set, .radius = 300, .strength = 1, .hardness = 1, .value = 0}, 80, 64);
  }
  auto maps = solve(*document);
  REQUIRE(maps);
  return *maps;
}

void look_from_above(test::Studio& studio) {
  studio.camera.position = {800, 100, 500};
  studio.camera.pitch = -30;
  studio.options.hour = 10;
}

/// A frame as the window draws it: nothing is waited for.
void draw_in_window(test::Studio& studio) {
  studio.target->bind();
  (void)studio.renderer->bring_in(studio.options);
  studio.renderer->draw(studio.camera, studio.options, studio.width, studio.height);
}

}  // namespace

TEST_CASE("Herds that come and go while the window draws are, in the end, those of the last snapshot") {
  const Maps all = valley_with(100);
  const Maps few = valley_with(1);
  REQUIRE(all->plans->size() != few->plans->size());
  test::Studio still;
  if (!still.open(160, 90)) return;
  look_from_above(still);
  still.renderer->set_snapshot(few);
  (void)still.draw();
  const std::vector<AnimalAt> expected(still.renderer->animals().begin(), still.renderer->animals().end());

  test::Studio window;
  REQUIRE(window.open(160, 90));
  look_from_above(window);
  window.renderer->set_snapshot(all);
  (void)window.draw();
  const std::size_t before = window.renderer->animals().size();
  CHECK(before > expected.size());
  for (int edit = 0; edit < 12; ++edit) {
    window.renderer->set_snapshot(edit % 2 == 0 ? few : all);
    for (int frame = 0; frame < 1 + edit % 4; ++frame) draw_in_window(window);
  }
  window.renderer->set_snapshot(few);
  int frames = 0;
  do {
    draw_in_window(window);
  } while (!window.renderer->complete() && ++frames < 2000);
  CHECK(window.renderer->complete());
  draw_in_window(window);
  const auto shown = window.renderer->animals();
  REQUIRE(shown.size() == expected.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    CHECK(shown[i].plan == expected[i].plan);
    CHECK(shown[i].place == expected[i].place);
  }
}
