// Models of plants that are made beside a window's frames and uploaded in pieces.
#include <chrono>

#include "render/plant_model_maker.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

using Clock = std::chrono::steady_clock;

/// Frames of a window until there is nothing more to come.
Image frames(Studio& studio) {
  const auto until = Clock::now() + std::chrono::seconds(30);
  do {
    (void)studio.renderer->bring_in(studio.options);
    studio.target->bind();
    studio.renderer->draw(studio.camera, studio.options, studio.width, studio.height);
  } while (!studio.renderer->complete() && Clock::now() < until);
  CHECK(studio.renderer->complete());
  return studio.target->read();
}

Image fresh(Studio& studio, const std::shared_ptr<const MapsSnapshot>& snapshot) {
  auto made = LandscapeRenderer::create();
  REQUIRE(made);
  std::swap(studio.renderer, *made);
  studio.renderer->set_snapshot(snapshot);
  Image picture = studio.draw();
  std::swap(studio.renderer, *made);
  return picture;
}

std::shared_ptr<MapsSnapshot> wood() {
  auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  cover(*snapshot, 2, 0.2F);
  return snapshot;
}

/// The same with a first tree of another form.
std::shared_ptr<MapsSnapshot> with_other_tree(const MapsSnapshot& before, float height) {
  auto after = std::make_shared<MapsSnapshot>(before);
  auto web = std::make_shared<FoodWeb>(*before.web);
  std::get<PlantTraits>(web->species[std::size_t(web->levels[0][0])].traits).shape.height = height;
  after->web = web;
  after->revision = before.revision + 1;
  return after;
}

}  // namespace

TEST_CASE("Models made beside a window's frames come to the picture of those made at once") {
  Studio studio;
  if (!studio.open(160, 120)) return;
  studio.camera.position = {256, 150, 101.7};
  const auto before = wood();
  studio.renderer->set_snapshot(before);
  CHECK(different(frames(studio), fresh(studio, before), 0) == 0);
  // Another form of a species comes while the window goes on, and so does the one after that.
  const auto taller = with_other_tree(*before, 31);
  const auto lower = with_other_tree(*before, 9);
  studio.renderer->set_snapshot(taller);
  (void)studio.renderer->bring_in(studio.options);
  studio.renderer->set_snapshot(lower);
  const Image shown = frames(studio);
  CHECK(different(shown, fresh(studio, lower), 0) == 0);
  CHECK(different(shown, fresh(studio, before)) > 100);
  // And back, as an undo does.
  studio.renderer->set_snapshot(taller);
  (void)studio.renderer->bring_in(studio.options);
  studio.renderer->set_snapshot(lower);
  CHECK(different(frames(studio), shown, 0) == 0);
}

TEST_CASE("The maker of models gives those of the web that was asked for last") {
  const auto before = wood();
  const auto after = with_other_tree(*before, 31);
  PlantModelMaker maker;
  CHECK(maker.take(Clock::now()) == nullptr);
  maker.start(before->web);
  maker.start(after->web);
  const auto made = maker.take(Clock::time_point::max());
  REQUIRE(made);
  CHECK(made->web == after->web);
  CHECK(made->meshes.size() == plant_models * after->web->levels[0].size());
  const auto at_once = make_plant_models(after->web);
  for (std::size_t i = 0; i < made->meshes.size(); ++i) {
    CHECK(made->meshes[i].near.indices == at_once->meshes[i].near.indices);
    CHECK(made->meshes[i].near.extent.height == at_once->meshes[i].near.extent.height);
  }
  CHECK(maker.take(Clock::now()) == nullptr);
}
