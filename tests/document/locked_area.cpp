#include <catch2/catch.hpp>

#include "tests/document/edit_support.hpp"

using namespace biotope;

namespace {

constexpr int width = 150;
constexpr int height = 100;

void perform(Document& document, const Edit& edit, const EditGrounds& grounds) {
  auto command = make_command(document, edit, grounds);
  if (!command) FAIL(command.error().message);
  if (*command) (*command)->apply(document);
}

std::shared_ptr<const SelectionMask> west_half() {
  return std::make_shared<const SelectionMask>(rectangle_selection(width, height, {0, 0}, {74, 99}));
}

FillEdit fill_of(const LayerId& layer, float value, BrushMode mode = BrushMode::set) {
  FillEdit edit;
  edit.targets = {{layer, 1, {}, {}}};
  edit.brush.mode = mode;
  edit.brush.strength = 1;
  edit.brush.value = value;
  return edit;
}

ImageEdit image_of(const LayerId& layer, float value) {
  ImageEdit edit;
  edit.layer = layer;
  edit.values = std::make_shared<const Grid<float>>(width, height, value);
  return edit;
}

/// Everything that changes paint, one of a kind, on a layer.
std::vector<Edit> all_edits(const LayerId& layer, std::uint64_t number) {
  StrokeEdit stroke;
  stroke.targets = {{layer, 1, {}, {}}};
  stroke.brush = random_brush(number, layer.kind);
  if (stroke.brush.mode == BrushMode::clone) stroke.clone_from = layer;
  stroke.points = random_points(number, width, height);
  FillEdit gradient = fill_of(layer, 0.7F);
  gradient.gradient = FillEdit::Gradient{{10, 10}, {140, 90}, 0.1F};
  MixEdit mix;
  mix.into = layer;
  mix.from = pine;
  mix.mix = LayerMix(random_int(0, 5, {number, 3}));
  MixEdit paste = mix;
  paste.paint = std::make_shared<const PaintLayer>([] {
    PaintLayer paint(width, height);
    for (int i = 0; i < 400; ++i) paint.set((i * 37) % width, (i * 11) % height, {0.4F, 0.9F});
    return paint;
  }());
  return {stroke, fill_of(layer, 0.3F), fill_of(layer, 0, BrushMode::restore_computed), gradient, image_of(layer, 0.6F), mix,
          paste,  ClearEdit{layer}};
}

LockEdit lock(LockEdit::How how) { return LockEdit{how}; }

}  // namespace

TEST_CASE("No edit of any kind changes paint in the locked area, and all do outside of it") {
  const EditGrounds grounds = made_up_grounds(width, height);
  for (std::uint64_t number = 1; number <= 25; ++number) {
    Document start = small_landscape(width, height);
    perform(start, fill_of(oak, 0.5F), grounds);
    perform(start, fill_of(pine, 0.2F), grounds);
    start.locked_area = west_half();
    for (const Edit& edit : all_edits(oak, number)) {
      CAPTURE(number, edit.index());
      Document document = start;
      perform(document, edit, grounds);
      Document free = start;
      free.locked_area = nullptr;
      perform(free, edit, grounds);
      bool kept = true;
      bool same_outside = true;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          if (x <= 74) kept = kept && paint_at(document, oak, x, y) == paint_at(start, oak, x, y);
          // Smoothing looks around, across the border too; the rest of a dab is the same.
          if (x > 74) same_outside = same_outside && paint_at(document, oak, x, y) == paint_at(free, oak, x, y);
        }
      }
      CHECK(kept);
      const auto* stroke = std::get_if<StrokeEdit>(&edit);
      const bool looks_around = stroke && (stroke->brush.mode == BrushMode::smooth || stroke->brush.mode == BrushMode::sharpen);
      if (!looks_around) CHECK(same_outside);
    }
  }
}

TEST_CASE("What is half locked changes by half") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  SelectionMask half(width, height);
  half.set(10, 10, 51);  // a fifth
  document.locked_area = std::make_shared<const SelectionMask>(half);
  perform(document, fill_of(moisture, 9), grounds);
  CHECK(paint_at(document, moisture, 10, 10).coverage == Approx(0.8F));
  CHECK(paint_at(document, moisture, 11, 10).coverage == 1);
  perform(document, ClearEdit{moisture}, grounds);
  CHECK(paint_at(document, moisture, 10, 10).coverage == Approx(0.8F * 0.2F));
  CHECK(paint_at(document, moisture, 11, 10) == Paint{});
}

TEST_CASE("Locking, locking more and unlocking are set algebra; what is wholly free has no locked area") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds;
  document.selection = west_half();
  perform(document, lock(LockEdit::How::add), grounds);
  REQUIRE(document.locked_area);
  CHECK(document.locked_area->to_grid() == document.selection->to_grid());
  const auto west = document.locked_area;

  document.selection = std::make_shared<const SelectionMask>(inverted(*west));
  perform(document, lock(LockEdit::How::add), grounds);
  REQUIRE(document.locked_area);
  CHECK((*document.locked_area)(0, 0) == 255);
  CHECK((*document.locked_area)(149, 99) == 255);

  perform(document, lock(LockEdit::How::subtract), grounds);
  REQUIRE(document.locked_area);
  CHECK(document.locked_area->to_grid() == west->to_grid());

  perform(document, lock(LockEdit::How::replace), grounds);
  CHECK(document.locked_area->to_grid() == document.selection->to_grid());

  perform(document, lock(LockEdit::How::subtract), grounds);
  CHECK(document.locked_area == nullptr);

  document.selection = nullptr;
  perform(document, lock(LockEdit::How::add), grounds);
  REQUIRE(document.locked_area);
  CHECK((*document.locked_area)(75, 50) == 255);
  perform(document, lock(LockEdit::How::nothing), grounds);
  CHECK(document.locked_area == nullptr);
  const auto again = make_command(document, lock(LockEdit::How::nothing), grounds);
  REQUIRE(again);
  CHECK(*again == nullptr);
}

TEST_CASE("Locking is a step of the history, which restores the area to the bit") {
  Document document = small_landscape(width, height);
  History history;
  document.selection = west_half();
  const auto step = [&](const Edit& edit) {
    auto command = make_command(document, edit, EditGrounds{});
    REQUIRE(command);
    REQUIRE(*command);
    history.perform(document, std::move(*command));
  };
  step(lock(LockEdit::How::add));
  const Grid<std::uint8_t> locked = document.locked_area->to_grid();
  CHECK(history.name(0) == "Lock the selection");
  step(lock(LockEdit::How::nothing));
  CHECK(document.locked_area == nullptr);
  REQUIRE(history.undo(document));
  REQUIRE(document.locked_area);
  CHECK(document.locked_area->to_grid() == locked);
  REQUIRE(history.undo(document));
  CHECK(document.locked_area == nullptr);
  CHECK(document.selection);
  REQUIRE(history.redo(document));
  CHECK(document.locked_area->to_grid() == locked);
}

TEST_CASE("What is painted becomes a selection, as far as the paint covers") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  SelectEdit painted;
  painted.shape = SelectEdit::Shape::painted;
  painted.range.map = moisture;
  CHECK_FALSE(make_command(document, painted, grounds));
  PaintLayer paint(width, height);
  paint.set(7, 8, {4, 1});
  paint.set(9, 8, {4, 0.5F});
  document.layers[moisture] = std::make_shared<const PaintLayer>(paint);
  perform(document, painted, grounds);
  REQUIRE(document.selection);
  CHECK((*document.selection)(7, 8) == 255);
  CHECK((*document.selection)(9, 8) == 128);
  CHECK((*document.selection)(8, 8) == 0);
}
