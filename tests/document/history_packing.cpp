#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/document/history.hpp"

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
const LayerId oak{LayerKind::plant_density, "oak"};

/// The same cells to the bit; a tile that is not there is a blank one.
bool same_bits(const PaintLayer& a, const PaintLayer& b) {
  static const PaintLayer::Tile blank{};
  for (std::size_t i = 0; i < a.tile_count(); ++i) {
    if (a.tile(i) == b.tile(i)) continue;
    const auto& one = a.tile(i) ? *a.tile(i) : blank;
    const auto& other = b.tile(i) ? *b.tile(i) : blank;
    if (std::memcmp(one.data(), other.data(), sizeof one) != 0) return false;
  }
  return true;
}

bool same_bits(const Document& a, const Document& b) {
  if (a.layers.size() != b.layers.size() || a.seed != b.seed || a.title != b.title) return false;
  for (const auto& [id, layer] : a.layers) {
    const auto other = b.layers.find(id);
    if (other == b.layers.end() || !same_bits(*layer, *other->second)) return false;
  }
  if (bool(a.selection) != bool(b.selection)) return false;
  return !a.selection || *a.selection == *b.selection;
}

std::unique_ptr<Command> random_stroke(Document& document, const Grid<float>& computed, const LayerId& layer, std::uint64_t number, int radius) {
  Brush brush;
  brush.mode = BrushMode(random_int(0, int(BrushMode::smooth), {number, 1}));
  brush.radius = float(random_int(2, radius, {number, 2}));
  brush.strength = float(0.2 + 0.8 * random_unit({number, 3}));
  brush.value = float(random_unit({number, 4})) * 9;
  Stroke stroke(layer, &computed);
  const float x = float(random_int(0, computed.width(), {number, 5}));
  const float y = float(random_int(0, computed.height(), {number, 6}));
  stroke.move_to(document, brush, x, y);
  stroke.move_to(document, brush, x + float(random_int(-150, 150, {number, 7})), y + float(random_int(-150, 150, {number, 8})));
  return stroke.finish(document);
}

/// Tiles that hold every odd number there is.
PaintLayer::TilePointer odd_tile(std::uint64_t seed) {
  auto tile = std::make_shared<PaintLayer::Tile>();
  const float odd[] = {0.0F, -0.0F, 1, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  for (std::uint64_t i = 0; i < tile->size(); ++i) {
    (*tile)[i] = {odd[random_int(0, 6, {seed, i, 1})], random_int(0, 1, {seed, i, 2}) == 0 ? float(random_unit({seed, i, 3})) : odd[i % 7]};
  }
  return tile;
}

}  // namespace

TEST_CASE("Packing a change of tiles loses nothing, whatever their cells hold") {
  PaintLayer layer(200, 200);
  std::vector<TileChanges<Paint>::Change> changes;
  for (std::size_t tile = 0; tile < layer.tile_count(); ++tile) {
    const auto before = tile % 3 == 0 ? nullptr : odd_tile(tile);
    const auto after = tile % 4 == 1 ? nullptr : odd_tile(tile % 5 == 0 ? tile : 100 + tile);
    layer.set_tile(tile, after);
    changes.push_back({tile, before, after});
  }
  PaintLayer shown = layer;
  TileChanges<Paint> packed(changes);
  packed.adopt(packed.pack_task(true)());
  CHECK_FALSE(packed.loose());
  packed.revert(shown);
  for (const auto& change : changes) {
    INFO(change.tile);
    REQUIRE(bool(shown.tile(change.tile)) == bool(change.before));
    if (change.before) REQUIRE(std::memcmp(shown.tile(change.tile)->data(), change.before->data(), sizeof(PaintLayer::Tile)) == 0);
  }
  packed.adopt(packed.pack_task(false)());
  packed.apply(shown);
  CHECK(same_bits(shown, layer));
}

TEST_CASE("What a small dab changed in a tile takes little room") {
  auto before = std::make_shared<PaintLayer::Tile>();
  for (std::size_t i = 0; i < before->size(); ++i) (*before)[i] = {float(random_unit({i})), 1};
  auto after = std::make_shared<PaintLayer::Tile>(*before);
  for (std::size_t i = 1000; i < 1020; ++i) (*after)[i].value += 0.5F;
  TileChanges<Paint> changes({{0, before, after}});
  changes.adopt(changes.pack_task(true)());
  CHECK(changes.own_bytes() < 500);
}

TEST_CASE("Steps of every kind are undone and redone to the bit however often they are packed") {
  Document document = blank_document(300, 260);
  const Grid<float> computed(300, 260, 4.0F);
  History history;
  std::vector<Document> states{document};
  for (std::uint64_t number = 0; number < 120; ++number) {
    std::unique_ptr<Command> command;
    const int kind = random_int(0, 5, {number, 20});
    if (kind < 3) {
      command = random_stroke(document, computed, kind == 0 ? oak : moisture, number, 40);
    } else if (kind == 3) {
      std::vector<std::unique_ptr<Command>> parts;
      for (std::uint64_t part = 0; part < 3; ++part) {
        if (auto one = random_stroke(document, computed, part == 2 ? oak : moisture, number * 10 + part, 30)) parts.push_back(std::move(one));
      }
      command = std::make_unique<GroupCommand>("Paint 3", std::move(parts));
    } else {
      Document after = document;
      after.seed = number;
      if (kind == 5) {
        after.layers.erase(number % 2 == 0 ? oak : moisture);
        SelectionMask mask(300, 260);
        for (int i = 0; i < 200; ++i) mask.set(random_int(0, 299, {number, 30, std::uint64_t(i)}), i, std::uint8_t(i));
        after.selection = number % 3 == 0 ? nullptr : std::make_shared<const SelectionMask>(mask);
      }
      command = std::make_unique<DocumentCommand>("Change", document, after);
      document = after;
    }
    if (!command) continue;
    history.record(std::move(command));
    if (number % 7 == 0) history.settle();
    states.push_back(document);
  }
  std::size_t at = states.size() - 1;
  REQUIRE(history.size() == at);
  for (std::uint64_t turn = 0; turn < 12; ++turn) {
    const auto wanted = turn == 4 ? 0 : turn == 7 ? states.size() - 1 : std::size_t(random_int(0, int(states.size()) - 1, {turn, 40}));
    while (at > wanted) {
      REQUIRE(history.undo(document));
      REQUIRE(same_bits(document, states[--at]));
    }
    while (at < wanted) {
      REQUIRE(history.redo(document));
      REQUIRE(same_bits(document, states[++at]));
    }
    if (turn % 2 == 0) history.settle();
  }
}

TEST_CASE("What was counted is given back when steps are packed, dropped and forgotten") {
  Document document = blank_document(512, 512);
  const Grid<float> computed(512, 512, 4.0F);
  History history;
  const std::size_t empty = history.bytes();
  for (std::uint64_t number = 0; number < 60; ++number) {
    if (auto command = random_stroke(document, computed, moisture, number, 60)) history.record(std::move(command));
  }
  const std::size_t before = history.bytes();
  history.settle();
  CHECK(history.bytes() <= before);
  CHECK(history.bytes() > 0);
  while (history.undo(document)) {
  }
  history.settle();
  while (history.redo(document)) {
  }
  history.settle();
  history.set_budget(1);
  CHECK(history.size() == 1);
  history.clear();
  CHECK(history.bytes() == empty);
}

TEST_CASE("A thousand strokes on 4096 x 4096 cells fit into 1 GB of history and are all undone to identity") {
  constexpr int side = 4096;
  Document document;
  {
    Terrain terrain;
    terrain.height = Grid<float>(side, side, 10.0F);
    document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  }
  // Paint that is there already: undoing to identity is not undoing to nothing.
  PaintLayer first(side, side);
  for (int i = 0; i < 2000; ++i) first.set(2 * i, 2 * i, {float(i), 1});
  document.layers[moisture] = std::make_shared<const PaintLayer>(first);
  const Document opened = document;
  const Grid<float> computed(side, side, 4.0F);

  History history(std::size_t(1) << 30);
  std::size_t steps = 0;
  std::size_t most = 0;
  for (std::uint64_t number = 0; steps < 1000; ++number) {
    auto command = random_stroke(document, computed, moisture, number, 60);
    if (!command) continue;
    history.record(std::move(command));
    ++steps;
    most = std::max(most, history.bytes());
  }
  const Document painted = document;
  CHECK(history.size() == steps);
  CHECK(most <= history.budget());
  history.settle();
  CHECK(history.bytes() < std::size_t(300) << 20);

  std::size_t undone = 0;
  while (history.undo(document)) ++undone;
  CHECK(undone == steps);
  CHECK(same_bits(document, opened));
  CHECK(history.bytes() <= history.budget());
  std::size_t redone = 0;
  while (history.redo(document)) ++redone;
  CHECK(redone == steps);
  CHECK(same_bits(document, painted));
}
