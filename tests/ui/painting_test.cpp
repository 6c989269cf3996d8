#include <catch2/catch.hpp>

#include "tests/ui/small_landscape.hpp"
#include "ui/background_task.hpp"
#include "ui/map_builder.hpp"
#include "ui/paint_session.hpp"

using namespace biotope;

namespace {

const LayerId grass{LayerKind::plant_density, "grass"};

Brush wide_brush() {
  Brush brush;
  brush.radius = 5;
  brush.strength = 1;
  brush.hardness = 1;
  return brush;
}

}  // namespace

TEST_CASE("what is painted shows at once, over what was computed") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(*snapshot, document, grass));
  CHECK((*session.shown())(3, 4) == Approx(0.5));
  (void)session.take_changed();
  const Rect rect = session.move_to(document, wide_brush(), 30, 30);
  CHECK(rect.contains(30, 30));
  CHECK(session.take_changed() == rect);
  CHECK(session.take_changed().empty());
  const auto paint = document.layers.at(grass);
  CHECK((*session.shown())(30, 30) == painted(0.0F, (*paint)(30, 30)));
  CHECK((*session.shown())(30, 30) > 0.9F);
  CHECK((*session.shown())(3, 4) == Approx(0.5));
  CHECK(session.greatest() == Approx((*session.shown())(30, 30)));
}

TEST_CASE("a stroke ends as one step that can be taken back") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  History history;
  PaintSession session;
  REQUIRE(session.begin(*snapshot, document, grass));
  for (float x = 10; x < 60; x += 3) session.move_to(document, wide_brush(), x, 30);
  auto command = session.finish(document);
  REQUIRE(command);
  CHECK_FALSE(session.stroking());
  history.record(std::move(command));
  CHECK(history.names().size() == 1);
  REQUIRE(history.undo(document));
  const auto found = document.layers.find(grass);
  CHECK((found == document.layers.end() || (*found->second)(30, 30).coverage == 0));
}

TEST_CASE("a second stroke on the same layer keeps the first one's picture") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  REQUIRE(session.begin(*snapshot, document, grass));
  session.move_to(document, wide_brush(), 20, 20);
  (void)session.finish(document);
  const auto picture = session.shown();
  REQUIRE(session.begin(*snapshot, document, grass));
  CHECK(session.shown() == picture);
  CHECK((*session.shown())(20, 20) > 0.9F);
}

TEST_CASE("a prepared ground is used only for its own layer and its own landscape") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  CHECK_FALSE(session.prepared(*snapshot, grass));
  session.prepare({grass, computed_source(*snapshot, grass), computed_under(*snapshot, grass)});
  CHECK(session.prepared(*snapshot, grass));
  CHECK_FALSE(session.prepared(*snapshot, {LayerKind::animal_density, "deer"}));
  const auto other = small_landscape();
  CHECK_FALSE(session.prepared(*other, grass));
  REQUIRE(session.begin(*snapshot, document, grass));
  CHECK((*session.shown())(3, 4) == Approx(0.5));
}

TEST_CASE("paint from before the stroke is in the picture from the start") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintLayer layer(70, 66);
  layer.set(65, 65, {1, 1});
  document.layers[grass] = std::make_shared<PaintLayer>(layer);
  PaintSession session;
  REQUIRE(session.begin(*snapshot, document, grass));
  CHECK((*session.shown())(65, 65) == 1);
  CHECK((*session.shown())(64, 65) == 0);
}

TEST_CASE("a map that is not computed yet cannot be painted") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  PaintSession session;
  CHECK_FALSE(session.begin(*snapshot, document, {LayerKind::resource, "moisture"}));
  CHECK_FALSE(session.stroking());
  CHECK(session.move_to(document, wide_brush(), 3, 3).empty());
  CHECK(document.layers.empty());
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
