#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/pipeline/solve.hpp"
#include "tests/render/studio.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

/// A frame as the window draws it: nothing is waited for.
void draw_in_window(test::Studio& studio) {
  studio.target->bind();
  (void)studio.renderer->bring_in(studio.options);
  studio.renderer->draw(studio.camera, studio.options, studio.width, studio.height);
}

std::vector<AnimalAt> animals_of(const test::Studio& studio) {
  return {studio.renderer->animals().begin(), studio.renderer->animals().end()};
}

bool same_places(const std::vector<AnimalAt>& a, const std::vector<AnimalAt>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const AnimalAt& one, const AnimalAt& other) {
    return one.plan == other.plan && one.member == other.member && one.place == other.place && one.heading == other.heading;
  });
}

}  // namespace

TEST_CASE("After the clock was set to another hour the window shows the animals of that hour, and no others in between") {
  const auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(document);
  const auto maps = solve(*document);
  REQUIRE(maps);
  test::Studio studio;
  if (!studio.open(160, 90)) return;
  studio.camera.position = {800, 100, 500};
  studio.camera.pitch = -30;
  studio.renderer->set_snapshot(*maps);
  const auto at_rest = [&](double hour) {
    studio.options.hour = hour;
    (void)studio.draw();
    return animals_of(studio);
  };
  const std::vector<AnimalAt> noon = at_rest(12.5);
  const std::vector<AnimalAt> morning = at_rest(7);
  REQUIRE(!noon.empty());
  REQUIRE_FALSE(same_places(noon, morning));
  studio.options.hour = 12.5;
  int frames = 0;
  do {
    draw_in_window(studio);
    const std::vector<AnimalAt> shown = animals_of(studio);
    CHECK((same_places(shown, noon) || same_places(shown, morning)));
  } while (!studio.renderer->complete() && ++frames < 2000);
  CHECK(studio.renderer->complete());
  CHECK(same_places(animals_of(studio), noon));
  // A moment later nothing is waited for.
  studio.options.hour = 12.5 + 1.0 / 3600;
  draw_in_window(studio);
  CHECK(studio.renderer->complete());
  CHECK_FALSE(same_places(animals_of(studio), noon));
}

TEST_CASE("Where very many animals are in sight a window shows them a moment late, and at rest where they are") {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(document);
  const auto solved = solve(*document);
  REQUIRE(solved);
  // Many of every grazer, wherever it lives.
  const AnimalLevel& grazers = *(*solved)->animals.front();
  for (const int species : grazers.species) {
    PaintLayer paint(document->terrain->height.width(), document->terrain->height.height());
    for (std::size_t t = 0; t < paint.tile_count(); ++t) paint.edit_tile(t).fill({600, 1});
    const std::string& name = (*solved)->web->species[std::size_t(species)].name;
    document->layers[{LayerKind::animal_density, name}] = std::make_shared<const PaintLayer>(std::move(paint));
  }
  const auto maps = solve(*document);
  REQUIRE(maps);
  test::Studio studio;
  if (!studio.open(160, 90)) return;
  studio.camera.position = {800, 100, 500};
  studio.camera.pitch = -30;
  studio.options.hour = 12.5;
  studio.renderer->set_snapshot(*maps);
  (void)studio.draw();
  const std::vector<AnimalAt> before = animals_of(studio);
  REQUIRE(before.size() > 800);
  studio.options.hour += 1.0 / 3600;
  draw_in_window(studio);
  CHECK(same_places(animals_of(studio), before));
  CHECK_FALSE(studio.renderer->complete());
  for (int frames = 0; !studio.renderer->complete() && frames < 2000; ++frames) draw_in_window(studio);
  const std::vector<AnimalAt> rested = animals_of(studio);
  (void)studio.draw();
  CHECK(same_places(rested, animals_of(studio)));
  CHECK_FALSE(same_places(rested, before));
}
