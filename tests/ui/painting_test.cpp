#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/ui/small_landscape.hpp"
#include "ui/background_task.hpp"
#include "ui/layer_values.hpp"
#include "ui/map_builder.hpp"
#include "ui/paint_grounds.hpp"
#include "ui/paint_session.hpp"

using namespace biotope;

namespace {

const LayerId grass{LayerKind::plant_density, "grass"};
const LayerId ground{LayerKind::ground, "height"};
const LayerId passage{LayerKind::passage, "all"};

Brush wide_brush() {
  Brush brush;
  brush.radius = 5;
  brush.strength = 1;
  brush.hardness = 1;
  return brush;
}

StrokePlan plan_of(const MapsSnapshot& snapshot, const LayerId& layer, const Brush& brush = wide_brush()) {
  StrokePlan plan;
  plan.targets = {EditTarget{layer, 1, {}, {}}};
  plan.computed = {computed_under(snapshot, layer)};
  plan.source = computed_source(snapshot, layer);
  plan.brush = brush;
  return plan;
}

}  // namespace

TEST_CASE("what is painted shows at once, over what was computed") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  CHECK((*session.shown())(3, 4) == Approx(0.5));
  (void)session.take_changed();
  const Rect rect = session.move_to(document, 30, 30);
  CHECK(rect.contains(30, 30));
  CHECK(session.take_changed() == rect);
  CHECK(session.take_changed().empty());
  const auto paint = document.layers.at(grass);
  CHECK((*session.shown())(30, 30) == painted(0.0F, (*paint)(30, 30)));
  CHECK((*session.shown())(30, 30) > 0.9F);
  CHECK((*session.shown())(3, 4) == Approx(0.5));
  CHECK(session.greatest() == Approx((*session.shown())(30, 30)));
}

TEST_CASE("a stroke ends as one step that can be taken back, and tells its points") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  History history;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  int points = 0;
  for (float x = 10; x < 60; x += 3, ++points) session.move_to(document, x, 30);
  FinishedStroke stroke = session.finish(document);
  REQUIRE(stroke.command);
  CHECK_FALSE(session.stroking());
  CHECK(int(stroke.edit.points.size()) == points);
  CHECK(stroke.edit.targets.front().layer == grass);
  history.record(std::move(stroke.command));
  CHECK(history.names().size() == 1);
  REQUIRE(history.undo(document));
  const auto found = document.layers.find(grass);
  CHECK((found == document.layers.end() || (*found->second)(30, 30).coverage == 0));
}

TEST_CASE("taking a stroke back shows at once, and so does doing it again") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  History history;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  session.move_to(document, 30, 30);
  history.record(session.finish(document).command);
  const float painted_value = (*session.shown())(30, 30);
  (void)session.take_changed();
  REQUIRE(history.undo(document));
  session.follow(document);
  CHECK((*session.shown())(30, 30) == 0);
  CHECK(session.take_changed().contains(30, 30));
  REQUIRE(history.redo(document));
  session.follow(document);
  CHECK((*session.shown())(30, 30) == painted_value);
}

TEST_CASE("hidden paint is not shown, and shows again when the eye is opened") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  session.move_to(document, 30, 30);
  (void)session.finish(document);
  document.layer_states[grass].hidden = true;
  session.follow(document);
  CHECK((*session.shown())(30, 30) == 0);
  document.layer_states[grass].hidden = false;
  session.follow(document);
  CHECK((*session.shown())(30, 30) > 0.9F);
}

TEST_CASE("a second stroke on the same layer keeps the first one's picture") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  session.move_to(document, 20, 20);
  (void)session.finish(document);
  const auto picture = session.shown();
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  CHECK(session.shown() == picture);
  CHECK((*session.shown())(20, 20) > 0.9F);
}

TEST_CASE("a computed map that changed gives a new picture") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  session.move_to(document, 20, 20);
  (void)session.finish(document);
  const auto picture = session.shown();
  const auto other = small_landscape();
  REQUIRE(session.begin(document, plan_of(*other, grass)));
  CHECK(session.shown() != picture);
  CHECK((*session.shown())(20, 20) > 0.9F);
}

TEST_CASE("paint from before the stroke is in the picture from the start") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintLayer layer(70, 66);
  layer.set(65, 65, {1, 1});
  document.layers[grass] = std::make_shared<PaintLayer>(layer);
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, grass)));
  CHECK((*session.shown())(65, 65) == 1);
  CHECK((*session.shown())(64, 65) == 0);
}

TEST_CASE("the painted ground shows how much it was raised, and nothing where it was not") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  Brush brush = wide_brush();
  brush.mode = BrushMode::raise;
  brush.value = 3;
  PaintSession session;
  REQUIRE(session.begin(document, plan_of(*snapshot, ground, brush)));
  session.move_to(document, 30, 30);
  CHECK((*session.shown())(30, 30) == Approx(3).margin(0.01));
  CHECK(std::isnan((*session.shown())(50, 30)));
}

TEST_CASE("obstacles and passages are shown as what they are") {
  CHECK(shown_value(LayerKind::passage, 0, {1, 1}) == obstacle_class);
  CHECK(shown_value(LayerKind::passage, 0, {-1, 1}) == open_class);
  CHECK(shown_value(LayerKind::passage, 0, {1, 0.3F}) == no_passage_class);
  CHECK(shown_value(LayerKind::geology, 2, {4, 0.6F}) == 4);
  CHECK(shown_value(LayerKind::geology, 2, {4, 0.4F}) == 2);
  CHECK(shown_value(LayerKind::plant_density, 0, {1, 0.25F}) == 0.25F);
}

TEST_CASE("a map that is not computed yet cannot be painted") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  CHECK_FALSE(session.begin(document, plan_of(*snapshot, {LayerKind::resource, "moisture"})));
  CHECK_FALSE(session.stroking());
  CHECK(session.move_to(document, 3, 3).empty());
  CHECK(document.layers.empty());
}

TEST_CASE("grounds are made once and only for their own landscape") {
  const auto snapshot = small_landscape();
  PaintGrounds grounds;
  CHECK_FALSE(grounds.ready(*snapshot, grass));
  const auto map = grounds.computed(*snapshot, grass);
  REQUIRE(map);
  CHECK(grounds.ready(*snapshot, grass));
  CHECK(grounds.computed(*snapshot, grass) == map);
  const auto other = small_landscape();
  CHECK_FALSE(grounds.ready(*other, grass));
  CHECK(grounds.computed(*other, grass) != map);
}

TEST_CASE("what a tool needs is made in the background") {
  const auto snapshot = small_landscape();
  PaintGrounds grounds;
  const PaintNeeds needs = needs_of_brush({grass, ground}, Brush{}, LayerId{LayerKind::animal_density, "deer"});
  REQUIRE(needs.layers.size() == 3);
  for (int i = 0; i < 10000 && !(grounds.ready(*snapshot, grass) && grounds.ready(*snapshot, ground)); ++i) {
    grounds.prepare(snapshot, snapshot->document, needs);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(grounds.ready(*snapshot, grass));
  CHECK(grounds.ready(*snapshot, ground));
  grounds.clear();
  CHECK_FALSE(grounds.ready(*snapshot, grass));
}

TEST_CASE("a final map has the paint that counts, and is the computed one where there is none") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintGrounds grounds;
  CHECK(grounds.final_of(*snapshot, document, grass) == grounds.computed(*snapshot, grass));
  PaintLayer layer(70, 66);
  layer.set(9, 8, {1, 0.5F});
  document.layers[grass] = std::make_shared<PaintLayer>(layer);
  const auto map = grounds.final_of(*snapshot, document, grass);
  CHECK((*map)(9, 8) == 0.5F);
  CHECK((*map)(3, 4) == Approx(0.5));
  document.layer_states[grass].hidden = true;
  CHECK((*grounds.final_of(*snapshot, document, grass))(9, 8) == 0);
}

TEST_CASE("work in the background is picked up once, with its failure as a value") {
  BackgroundTask<int> task;
  CHECK_FALSE(task.running());
  task.start("good", [](const TaskContext&) -> Result<int> { return 7; });
  std::optional<Result<int>> result;
  while (!(result = task.take())) std::this_thread::yield();
  CHECK(**result == 7);
  CHECK_FALSE(task.take());
  task.start("bad", [](const TaskContext&) -> Result<int> { return fail("no such file"); });
  while (!(result = task.take())) std::this_thread::yield();
  CHECK(result->error().message == "no such file");
}

TEST_CASE("stopped work is asked to stop and forgotten") {
  BackgroundTask<int> task;
  task.start("long", [](const TaskContext& context) -> Result<int> {
    while (!context.stopped()) std::this_thread::yield();
    return fail("stopped");
  });
  task.cancel();
  CHECK_FALSE(task.running());
  CHECK_FALSE(task.take());
}
