#include "core/document/history.hpp"

#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"

using namespace biotope;

namespace {

Document blank_document(int width, int height) {
  Document document;
  Terrain terrain;
  terrain.height = Grid<float>(width, height, 10.0F);
  document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  return document;
}

const LayerId moisture{LayerKind::resource, "moisture"};

/// One random stroke of up to five points over `layer`.
std::unique_ptr<Command> random_stroke(Document& document, const Grid<float>& computed, std::uint64_t number) {
  Brush brush;
  brush.mode = BrushMode(random_int(0, 4, {number, 1}));
  brush.radius = float(random_int(1, 30, {number, 2}));
  brush.strength = float(random_unit({number, 3}));
  brush.value = float(random_unit({number, 4})) * 9;
  Stroke stroke(moisture, &computed);
  const int points = random_int(1, 5, {number, 5});
  for (int i = 0; i < points; ++i) {
    const auto at = std::uint64_t(i);
    stroke.move_to(document, brush, float(random_int(-10, computed.width() + 10, {number, 6, at})),
                   float(random_int(-10, computed.height() + 10, {number, 7, at})));
  }
  return stroke.finish(document);
}

bool same_paint(const Document& a, const Document& b) {
  const PaintLayer blank(a.terrain->height.width(), a.terrain->height.height());
  const auto layer = [&](const Document& d) {
    const auto found = d.layers.find(moisture);
    return found == d.layers.end() ? blank : *found->second;
  };
  return layer(a) == layer(b);
}

}  // namespace

TEST_CASE("Undo after do is identity, and redo after undo is do, for any strokes") {
  Document document = blank_document(150, 90);
  const Grid<float> computed(150, 90, 4.0F);
  History history;
  std::vector<Document> states{document};
  for (std::uint64_t number = 0; number < 60; ++number) {
    if (auto command = random_stroke(document, computed, number)) {
      history.record(std::move(command));
      states.push_back(document);
    }
  }
  REQUIRE(states.size() > 30);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    REQUIRE(history.undo(document));
    REQUIRE(same_paint(document, states[i]));
  }
  CHECK_FALSE(history.undo(document));
  for (std::size_t i = 1; i < states.size(); ++i) {
    REQUIRE(history.redo(document));
    REQUIRE(same_paint(document, states[i]));
  }
  CHECK_FALSE(history.redo(document));
}

TEST_CASE("A new step forgets what could be redone") {
  Document document = blank_document(64, 64);
  const Grid<float> computed(64, 64, 4.0F);
  History history;
  Brush brush;
  brush.value = 9;
  for (int i = 0; i < 3; ++i) {
    if (i == 2) history.undo(document);
    Stroke stroke(moisture, &computed);
    stroke.dab(document, brush, float(10 * i), 20);
    history.record(stroke.finish(document));
  }
  CHECK_FALSE(history.can_redo());
  CHECK(history.names().size() == 2);
  CHECK(history.size() == 2);
}

TEST_CASE("The byte budget drops the oldest steps but never the newest") {
  Document document = blank_document(256, 256);
  const Grid<float> computed(256, 256, 4.0F);
  constexpr std::size_t budget = 20000;
  History history(budget);
  Brush brush;
  brush.radius = 20;
  brush.value = 9;
  for (int i = 0; i < 10; ++i) {
    Stroke stroke(moisture, &computed);
    stroke.dab(document, brush, float(20 + 20 * i), 100);
    history.record(stroke.finish(document));
    CHECK(history.can_undo());
  }
  CHECK(history.size() < 10);
  CHECK(history.size() + history.dropped() == 10);
  // At most the newest step and what was there before it.
  CHECK(history.bytes() <= budget + 9 * sizeof(PaintLayer::Tile));
}

TEST_CASE("A slider that is dragged is one step") {
  Document document = blank_document(64, 64);
  History history;
  const auto set_seed = [&](std::uint64_t seed, const char* key) {
    Document after = document;
    after.seed = seed;
    history.perform(document, std::make_unique<DocumentCommand>("Seed", document, std::move(after)), key);
  };
  for (std::uint64_t seed = 2; seed <= 50; ++seed) set_seed(seed, "seed drag 1");
  CHECK(history.size() == 1);
  set_seed(60, "seed drag 2");
  CHECK(history.size() == 2);
  set_seed(70, "");
  set_seed(80, "");
  CHECK(history.size() == 4);
  while (history.size() > 0 && history.undo(document)) {
  }
  CHECK(document.seed == 1);
  // Merging does not reach over an undo.
  REQUIRE(history.redo(document));
  CHECK(document.seed == 50);
  set_seed(51, "seed drag 1");
  CHECK(history.size() == 2);
  REQUIRE(history.undo(document));
  CHECK(document.seed == 50);
}

TEST_CASE("Many small steps take little memory and little time") {
  Document document = blank_document(512, 512);
  History history;
  for (std::uint64_t seed = 2; seed < 5000; ++seed) {
    Document after = document;
    after.seed = seed;
    history.perform(document, std::make_unique<DocumentCommand>("Seed", document, std::move(after)));
  }
  CHECK(history.size() == 4998);
  CHECK(history.bytes() < 4998 * 8000);
  CHECK(history.name(17) == "Seed");
  while (history.undo(document)) {
  }
  CHECK(document.seed == 1);
}
