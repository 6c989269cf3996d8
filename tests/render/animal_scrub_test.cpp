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
