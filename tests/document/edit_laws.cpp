#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "tests/document/edit_support.hpp"

using namespace biotope;

namespace {

constexpr int width = 170;
constexpr int height = 100;

const std::vector<LayerId> layers{oak, pine, deer, moisture, geology, ground, passage};

LayerId random_layer(std::uint64_t number, std::uint64_t what) {
  return layers[std::size_t(random_int(0, int(layers.size()) - 1, {number, 50, what}))];
}

BrushFilter random_filter(std::uint64_t number) {
  BrushFilter filter;
  const int kind = random_int(0, 3, {number, 51});
  if (kind == 0) filter.conditions.push_back({.quantity = FilterQuantity::slope, .low = 30, .high = 120, .softness = 20});
  if (kind == 1) {
    filter.conditions.push_back(
        {.quantity = FilterQuantity::map, .map = random_layer(number, 2), .low = 0.3F, .high = 5, .inverted = true});
  }
  filter.use_selection = random_int(0, 3, {number, 52}) > 0;
  return filter;
}

std::vector<EditTarget> random_targets(std::uint64_t number) {
  std::vector<EditTarget> targets{{random_layer(number, 3), 1, {}, {}}};
  if (random_int(0, 2, {number, 53}) == 0)
    targets.push_back({random_layer(number, 4), float(random_unit({number, 54})), 0.5F, {}});
  return targets;
}

StrokeEdit random_stroke(std::uint64_t number) {
  StrokeEdit edit;
  edit.targets = random_targets(number);
  edit.brush = random_brush(number, edit.targets.front().layer.kind);
  edit.brush.filter = random_filter(number);
  edit.clone_from = random_layer(number, 5);
  edit.points = random_points(number, width, height);
  return edit;
}

FillEdit random_fill(std::uint64_t number) {
  const StrokeEdit stroke = random_stroke(number);
  FillEdit edit;
  edit.targets = stroke.targets;
  edit.brush = stroke.brush;
  edit.clone_from = stroke.clone_from;
  if (random_int(0, 1, {number, 55}) == 1) edit.gradient = FillEdit::Gradient{{3, 4}, {90, 70}, 0.9F};
  return edit;
}

SelectEdit random_selection(std::uint64_t number) {
  SelectEdit edit;
  edit.shape = SelectEdit::Shape(random_int(0, 5, {number, 56}));
  edit.mode = SelectionMode(random_int(0, 3, {number, 57}));
  const int points = edit.shape == SelectEdit::Shape::rectangle ? 2 : 6;
  for (std::uint64_t i = 0; i < std::uint64_t(points); ++i) {
    edit.points.push_back({float(random_unit({number, 58, i})) * width, float(random_unit({number, 59, i})) * height});
  }
  edit.range = {.quantity = FilterQuantity::slope, .low = 20, .high = 90, .softness = 10};
  return edit;
}

Edit random_edit(std::uint64_t number) {
  switch (random_int(0, 9, {number, 60})) {
    case 0:
      return random_fill(number);
    case 1:
      return random_selection(number);
    case 2:
      return ClearEdit{random_layer(number, 6)};
    case 3: {
      ImageEdit image;
      image.layer = random_layer(number, 7);
      image.values = std::make_shared<const Grid<float>>(random_map(width, height, number));
      image.opacity = float(random_unit({number, 61}));
      return image;
    }
    case 4: {
      MixEdit mix;
      mix.into = random_layer(number, 8);
      mix.from = random_layer(number, 9);
      mix.mix = LayerMix(random_int(0, 5, {number, 62}));
      return mix;
    }
    case 5:
      return PartsEdit{"Lock or hide", [number](Document& document) {
                         LayerState& state = document.layer_states[random_layer(number, 10)];
                         state.locked = random_int(0, 3, {number, 63}) == 0;
                         state.hidden = !state.hidden;
                       }};
    case 6:
      return LockEdit{LockEdit::How(std::min(random_int(0, 5, {number, 64}), 3))};
    default:
      return random_stroke(number);
  }
}

}  // namespace

TEST_CASE("Any sequence of edits of any kind is undone to the bit, step by step, and done again to the bit") {
  for (std::uint64_t sequence = 0; sequence < 12; ++sequence) {
    const EditGrounds grounds = made_up_grounds(width, height);
    Document document = small_landscape(width, height);
    std::vector<std::unique_ptr<Command>> commands;
    std::vector<Document> states{document};
    for (std::uint64_t step = 0; step < 60; ++step) {
      auto command = make_command(document, random_edit(1000 * sequence + step), grounds);
      // A locked layer, or classes and numbers to be mixed, fail; the document must be the same.
      if (!command || !*command) continue;
      REQUIRE(same_state(document, states.back()));
      (*command)->apply(document);
      commands.push_back(std::move(*command));
      states.push_back(document);
      REQUIRE_FALSE(same_state(states[states.size() - 2], document));
    }
    REQUIRE(commands.size() > 15);
    for (std::size_t i = commands.size(); i-- > 0;) {
      commands[i]->revert(document);
      REQUIRE(same_state(document, states[i]));
    }
    for (std::size_t i = 0; i < commands.size(); ++i) {
      commands[i]->apply(document);
      REQUIRE(same_state(document, states[i + 1]));
    }
  }
}

TEST_CASE("A stroke painted live, frame by frame, is the stroke played again, to the bit") {
  int painted_strokes = 0;
  for (std::uint64_t number = 0; number < 120; ++number) {
    const EditGrounds grounds = made_up_grounds(width, height);
    Document live = small_landscape(width, height);
    if (number % 2 == 1) {
      auto select = make_command(live, random_selection(number + 7), grounds);
      if (select && *select) (*select)->apply(live);
    }
    Document replayed = live;
    const StrokeEdit edit = random_stroke(number);
    const auto ground = stroke_ground(live, edit.targets, edit.brush, edit.clone_from, grounds);
    REQUIRE(ground);
    Stroke stroke(ground->targets, &ground->maps);
    std::vector<Document> published;
    for (const auto& point : edit.points) {
      stroke.move_to(live, edit.brush, point.x, point.y, point.pressure);
      published.push_back(live);
    }
    const auto live_command = stroke.finish(live);
    const auto command = make_command(replayed, edit, grounds);
    REQUIRE(command);
    REQUIRE((live_command != nullptr) == (*command != nullptr));
    if (*command) (*command)->apply(replayed);
    painted_strokes += *command ? 1 : 0;
    REQUIRE(same_state(live, replayed));
    if (live_command) REQUIRE(live_command->name() == (*command)->name());
  }
  CHECK(painted_strokes > 60);
}

TEST_CASE("Locked layers are the same to the bit after any edit") {
  const EditGrounds grounds = made_up_grounds(width, height);
  Document document = small_landscape(width, height);
  for (const LayerId& layer : layers) {
    FillEdit fill;
    fill.targets = {{layer, 0.7F, 2.0F, {}}};
    fill.brush.mode = BrushMode::set;
    auto command = make_command(document, fill, grounds);
    REQUIRE((command && *command));
    (*command)->apply(document);
  }
  for (const LayerId& layer : {oak, geology, moisture}) document.layer_states[layer].locked = true;
  const Document before = document;
  int done = 0;
  for (std::uint64_t number = 0; number < 150; ++number) {
    Edit edit = random_edit(number);
    if (std::holds_alternative<PartsEdit>(edit)) continue;
    auto command = make_command(document, edit, grounds);
    if (!command || !*command) continue;
    (*command)->apply(document);
    ++done;
  }
  CHECK(done > 30);
  for (const LayerId& layer : {oak, geology, moisture}) CHECK(document.layers.at(layer) == before.layers.at(layer));
}

TEST_CASE("A fill is a dab that reaches everywhere") {
  const EditGrounds grounds = made_up_grounds(width, height);
  for (std::uint64_t number = 0; number < 40; ++number) {
    FillEdit fill = random_fill(number);
    fill.gradient.reset();
    fill.brush.pressure_sizes = false;
    fill.brush.hardness = 1;
    fill.brush.radius = 400;
    StrokeEdit stroke{fill.targets, fill.brush, fill.clone_from, {{80, 50, 1}}};
    Document filled = small_landscape(width, height);
    Document dabbed = filled;
    const auto fill_step = make_command(filled, fill, grounds);
    const auto stroke_step = make_command(dabbed, stroke, grounds);
    REQUIRE((fill_step && stroke_step));
    if (*fill_step) (*fill_step)->apply(filled);
    if (*stroke_step) (*stroke_step)->apply(dabbed);
    REQUIRE(same_state(filled, dabbed));
  }
}
