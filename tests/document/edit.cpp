#include "core/document/edit.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/document/edit_support.hpp"

using namespace biotope;

namespace {

constexpr int width = 150;
constexpr int height = 100;

/// Does an edit that must change something.
void perform(Document& document, const Edit& edit, const EditGrounds& grounds) {
  auto command = make_command(document, edit, grounds);
  REQUIRE(command);
  REQUIRE(*command);
  CHECK((*command)->name() == edit_name(edit, document));
  (*command)->apply(document);
}

bool changes_nothing(const Document& document, const Edit& edit, const EditGrounds& grounds) {
  const auto command = make_command(document, edit, grounds);
  return command && *command == nullptr;
}

FillEdit fill_of(const LayerId& layer, float value, BrushMode mode = BrushMode::set, float strength = 1) {
  FillEdit edit;
  edit.targets = {{layer, 1, {}, {}}};
  edit.brush.mode = mode;
  edit.brush.strength = strength;
  edit.brush.value = value;
  return edit;
}

FilterCondition eastern_half() {
  FilterCondition condition;
  condition.quantity = FilterQuantity::slope;
  condition.low = 75;
  condition.high = 1000;
  return condition;
}

MixEdit mix_of(const LayerId& into, const LayerId& from, LayerMix mix) {
  MixEdit edit;
  edit.into = into;
  edit.from = from;
  edit.mix = mix;
  return edit;
}

float final_at(const Document& document, const EditGrounds& grounds, const LayerId& layer, int x, int y) {
  return painted((*grounds.computed(layer))(x, y), paint_at(document, layer, x, y));
}

}  // namespace

TEST_CASE("A fill covers what filter and selection let pass, makes only those tiles, and again changes nothing") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  FillEdit fill = fill_of(moisture, 7);
  fill.brush.filter.conditions = {eastern_half()};
  perform(document, fill, grounds);
  CHECK(paint_at(document, moisture, 74, 50) == Paint{});
  CHECK(paint_at(document, moisture, 75, 50) == Paint{7, 1});
  CHECK(document.layers.at(moisture)->tile(0) == nullptr);
  CHECK(changes_nothing(document, fill, grounds));

  document.selection = std::make_shared<const SelectionMask>(rectangle_selection(width, height, {100, 20}, {110, 30}));
  perform(document, fill_of(moisture, 2), grounds);
  CHECK(paint_at(document, moisture, 105, 25).value == 2.0F);
  CHECK(paint_at(document, moisture, 111, 25).value == 7.0F);
  perform(document, fill_of(moisture, 0, BrushMode::restore_computed), grounds);
  CHECK(paint_at(document, moisture, 105, 25) == Paint{});
  CHECK(paint_at(document, moisture, 99, 25).value == 7.0F);
}

TEST_CASE("A gradient goes evenly from its start to its end and stays there beyond") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  FillEdit fill = fill_of(moisture, 2);
  fill.gradient = FillEdit::Gradient{{20, 10}, {120, 10}, 8};
  perform(document, fill, grounds);
  CHECK(paint_at(document, moisture, 0, 50).value == 2.0F);
  CHECK(paint_at(document, moisture, 70, 90).value == Approx(5.0F));
  CHECK(paint_at(document, moisture, 45, 0).value == Approx(3.5F));
  CHECK(paint_at(document, moisture, 140, 50).value == 8.0F);
  fill.gradient = FillEdit::Gradient{{20, 10}, {20, 10}, 8};
  perform(document, fill, grounds);
  CHECK(paint_at(document, moisture, 140, 50).value == 2.0F);
  // Rock goes from one class to the other without those between.
  FillEdit rock = fill_of(geology, 0);
  rock.gradient = FillEdit::Gradient{{0, 0}, {100, 0}, 4};
  perform(document, rock, grounds);
  for (int x = 0; x < width; ++x) REQUIRE(paint_at(document, geology, x, 5).value == (x < 50 ? 0.0F : 4.0F));
}

TEST_CASE("A fill takes several layers in one step") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  FillEdit fill = fill_of(oak, 0.5F);
  fill.targets.push_back({pine, 1, 0.25F, {}});
  const Document before = document;
  auto command = make_command(document, fill, grounds);
  REQUIRE((command && *command));
  CHECK((*command)->name() == "Fill oak and 1 more");
  (*command)->apply(document);
  CHECK(paint_at(document, oak, 3, 3).value == 0.5F);
  CHECK(paint_at(document, pine, 3, 3).value == 0.25F);
  (*command)->revert(document);
  CHECK(same_state(document, before));
}

TEST_CASE("Selections are drawn, met and turned round") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  SelectEdit select;
  select.shape = SelectEdit::Shape::everything;
  CHECK(changes_nothing(document, select, grounds));
  select.shape = SelectEdit::Shape::rectangle;
  select.points = {{10, 10}, {19, 19}};
  perform(document, select, grounds);
  CHECK(selected(document.selection.get(), 10, 19) == 1.0F);
  CHECK(selected(document.selection.get(), 20, 19) == 0.0F);
  CHECK(changes_nothing(document, select, grounds));
  select.points = {{15, 10}, {40, 40}};
  select.mode = SelectionMode::subtract;
  perform(document, select, grounds);
  CHECK(selected(document.selection.get(), 14, 12) == 1.0F);
  CHECK(selected(document.selection.get(), 15, 12) == 0.0F);
  SelectEdit inverse;
  inverse.shape = SelectEdit::Shape::inverse;
  perform(document, inverse, grounds);
  CHECK(selected(document.selection.get(), 14, 12) == 0.0F);
  CHECK(selected(document.selection.get(), 15, 12) == 1.0F);
  SelectEdit range;
  range.shape = SelectEdit::Shape::range;
  range.mode = SelectionMode::intersect;
  range.range = eastern_half();
  perform(document, range, grounds);
  CHECK(selected(document.selection.get(), 75, 3) == 1.0F);
  CHECK(selected(document.selection.get(), 74, 3) == 0.0F);
  SelectEdit nothing;
  nothing.shape = SelectEdit::Shape::nothing;
  perform(document, nothing, grounds);
  CHECK(changes_nothing(document, fill_of(moisture, 3), grounds));
  perform(document, inverse, grounds);
  CHECK(document.selection == nullptr);
}

TEST_CASE("A range of a layer's own map counts its paint, unless it is hidden") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  StrokeEdit stroke;
  stroke.targets = {{moisture, 1, {}, {}}};
  stroke.brush = {.mode = BrushMode::set, .radius = 10, .strength = 1, .hardness = 1, .value = 9};
  stroke.points = {{50, 50, 1}};
  perform(document, stroke, grounds);
  SelectEdit range;
  range.shape = SelectEdit::Shape::range;
  range.range.quantity = FilterQuantity::map;
  range.range.map = moisture;
  range.range.low = 8;
  range.range.high = 9;
  perform(document, range, grounds);
  CHECK(selected(document.selection.get(), 50, 50) == 1.0F);
  CHECK(selected(document.selection.get(), 80, 50) == 0.0F);
  document.layer_states[moisture].hidden = true;
  perform(document, range, grounds);
  CHECK(selected(document.selection.get(), 50, 50) == 0.0F);
}

TEST_CASE("Clearing takes all paint off and gives the computed map back") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  CHECK(changes_nothing(document, ClearEdit{oak}, grounds));
  perform(document, fill_of(oak, 1), grounds);
  perform(document, ClearEdit{oak}, grounds);
  CHECK(document.layers.empty());
}

TEST_CASE("An image is laid over a layer, but for its cells without a number") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  auto image = std::make_shared<Grid<float>>(width, height, 6.0F);
  (*image)(5, 5) = std::numeric_limits<float>::quiet_NaN();
  (*image)(6, 5) = 40;
  ImageEdit edit;
  edit.layer = moisture;
  edit.values = image;
  edit.opacity = 0.5F;
  edit.filter.conditions = {};
  perform(document, edit, grounds);
  CHECK(paint_at(document, moisture, 5, 5) == Paint{});
  CHECK(paint_at(document, moisture, 6, 5) == Paint{9, 0.5F});
  CHECK(paint_at(document, moisture, 4, 5) == Paint{6, 0.5F});
  CHECK(paint_at(document, moisture, 5, 4) == Paint{6, 0.5F});
  CHECK(final_at(document, grounds, moisture, 30, 30) == Approx(5.5F));
  edit.values = std::make_shared<const Grid<float>>(width + 1, height, 6.0F);
  CHECK_FALSE(make_command(document, edit, grounds));
  edit.values = nullptr;
  CHECK_FALSE(make_command(document, edit, grounds));
}

TEST_CASE("Layers are mixed as masks and as colours are") {
  const EditGrounds grounds = made_up_grounds(width, height);
  const auto mixed = [&](LayerMix mix, Paint own, Paint other) {
    Document document = small_landscape(width, height);
    PaintLayer mine(width, height);
    if (own.coverage > 0) mine.set(40, 40, own);
    auto theirs = std::make_shared<PaintLayer>(width, height);
    if (other.coverage > 0) theirs->set(40, 40, other);
    if (own.coverage > 0) document.layers[pine] = std::make_shared<const PaintLayer>(std::move(mine));
    MixEdit edit = mix_of(pine, oak, mix);
    edit.paint = theirs;
    const auto command = make_command(document, edit, grounds);
    REQUIRE(command);
    if (*command) (*command)->apply(document);
    return paint_at(document, pine, 40, 40);
  };
  const Paint a{0.25F, 0.5F};
  const Paint b{0.75F, 0.5F};
  CHECK(mixed(LayerMix::replace, a, b) == b);
  CHECK(mixed(LayerMix::replace, a, {}) == Paint{});
  // Over: what is final is the other paint over what was final before.
  CHECK(painted(0.1F, mixed(LayerMix::over, a, b)) == Approx(painted(painted(0.1F, a), b)));
  CHECK(painted(0.1F, mixed(LayerMix::under, a, b)) == Approx(painted(painted(0.1F, b), a)));
  CHECK(mixed(LayerMix::under, {0.2F, 1}, b) == Paint{0.2F, 1});
  CHECK(mixed(LayerMix::under, {}, b) == b);
  CHECK(mixed(LayerMix::subtract, a, b) == Paint{0.25F, 0.25F});
  CHECK(mixed(LayerMix::subtract, a, {0.1F, 1}) == Paint{});
  CHECK(mixed(LayerMix::subtract, a, {}) == a);
  CHECK(mixed(LayerMix::intersect, a, b) == Paint{0.25F, 0.25F});
  CHECK(mixed(LayerMix::intersect, a, {}) == Paint{});
  CHECK(mixed(LayerMix::intersect, a, {0.9F, 1}) == a);
  CHECK(mixed(LayerMix::maximum, a, b) == b);
  CHECK(mixed(LayerMix::maximum, b, a) == b);
  CHECK(mixed(LayerMix::maximum, a, {}) == a);
  // Values of another unit are cut to what the layer may hold.
  CHECK(mixed(LayerMix::replace, a, {40, 1}) == Paint{1, 1});
}

TEST_CASE("Mixing keeps to the selection, and classes of rock to themselves") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  perform(document, fill_of(oak, 1), grounds);
  document.selection = std::make_shared<const SelectionMask>(rectangle_selection(width, height, {0, 0}, {9, 9}));
  perform(document, mix_of(pine, oak, LayerMix::over), grounds);
  CHECK(paint_at(document, pine, 9, 9) == Paint{1, 1});
  CHECK(paint_at(document, pine, 10, 9) == Paint{});
  CHECK(changes_nothing(document, mix_of(deer, pine, LayerMix::intersect), grounds));
  CHECK_FALSE(make_command(document, mix_of(geology, oak, LayerMix::over), grounds));
  CHECK_FALSE(make_command(document, mix_of(oak, geology, LayerMix::over), grounds));
  CHECK_FALSE(make_command(document, mix_of(geology, geology, LayerMix::maximum), grounds));
}

TEST_CASE("Parts change in one step, and a change that changes nothing is none") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  const Document before = document;
  PartsEdit lock{"Lock oak", [](Document& changed) { changed.layer_states[oak].locked = true; }};
  auto command = make_command(document, lock, grounds);
  REQUIRE((command && *command));
  CHECK((*command)->name() == "Lock oak");
  (*command)->apply(document);
  CHECK(is_locked(document, oak));
  CHECK(changes_nothing(document, lock, grounds));
  (*command)->revert(document);
  CHECK(same_state(document, before));
  CHECK_FALSE(make_command(document, PartsEdit{"Nothing", {}}, grounds));
}

TEST_CASE("An edit that cannot be done says why, and leaves the document as it is") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto fails = [&](const Edit& edit, const std::string& word) {
    const auto command = make_command(document, edit, grounds);
    INFO(edit_name(edit, document));
    REQUIRE_FALSE(command);
    CHECK(command.error().message.find(word) != std::string::npos);
  };
  fails(fill_of({LayerKind::plant_density, "unicorn"}, 1), "unicorn");
  fails(fill_of({LayerKind::plant_density, "deer"}, 1), "deer");
  fails(fill_of({LayerKind::resource, "gold"}, 1), "gold");
  fails(fill_of({LayerKind::geology, "kind"}, 1), "kind");
  fails(FillEdit{}, "No layer");
  fails(fill_of(oak, nan), "not a number");
  fails(fill_of(oak, 1, BrushMode::clone), "clone");
  document.layer_states[oak].locked = true;
  fails(fill_of(oak, 1), "locked");
  fails(ClearEdit{oak}, "locked");
  fails(mix_of(oak, pine, LayerMix::over), "locked");
  ImageEdit image;
  image.layer = oak;
  image.values = std::make_shared<const Grid<float>>(width, height, 1.0F);
  fails(image, "locked");
  FillEdit filtered = fill_of(pine, 1);
  filtered.brush.filter.conditions = {FilterCondition{.quantity = FilterQuantity::water_distance, .low = 0, .high = 9}};
  fails(filtered, "distance to water");
  StrokeEdit stroke;
  stroke.targets = {{pine, 1, {}, {}}};
  stroke.points = {{nan, 4, 1}};
  fails(stroke, "point");
  stroke.points = {{1e9F, 4, 1}};
  fails(stroke, "point");
  SelectEdit select;
  select.shape = SelectEdit::Shape::lasso;
  select.points = {{1, 1}, {2, 2}};
  fails(select, "three points");
  CHECK(document.layers.empty());
  EditGrounds unknown;
  CHECK_FALSE(make_command(document, fill_of(pine, 1), unknown));
  // Losses, passages and the ground are known without any computation.
  CHECK(make_command(document, fill_of(passage, 1), unknown));
  CHECK(make_command(document, fill_of({LayerKind::loss, "deer"}, 1), unknown));
  CHECK(make_command(document, fill_of(ground, 300), unknown));
}

TEST_CASE("A locked layer among others stays as it is") {
  Document document = small_landscape(width, height);
  const EditGrounds grounds = made_up_grounds(width, height);
  document.layer_states[oak].locked = true;
  FillEdit fill = fill_of(oak, 1);
  fill.targets.push_back({pine, 1, {}, {}});
  auto command = make_command(document, fill, grounds);
  REQUIRE((command && *command));
  (*command)->apply(document);
  CHECK_FALSE(document.layers.contains(oak));
  CHECK(paint_at(document, pine, 3, 3).value == 1.0F);
}
