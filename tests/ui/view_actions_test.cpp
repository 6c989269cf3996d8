#include <catch2/catch.hpp>

#include "tests/ui/small_landscape.hpp"
#include "ui/editor_state.hpp"
#include "ui/exploring.hpp"
#include "ui/picture_export.hpp"

using namespace biotope;

namespace {

std::unique_ptr<EditorState> editor() {
  auto state = std::make_unique<EditorState>();
  state->shown = small_landscape();
  state->document = state->shown->document;
  state->has_document = true;
  state->view.camera.position = {100, 200, 80};
  state->view.camera_placed = true;
  return state;
}

/// Time passes until the camera has arrived.
void arrive(EditorState& state) {
  for (int i = 0; i < 100 && state.exploring.flight; ++i) advance_exploring(state, 0.05);
}

}  // namespace

TEST_CASE("a bookmark brings back view, hour and month, and makes the scene unsaved") {
  const auto state = editor();
  state->clock.hour = 6.5;
  state->clock.month = 9;
  CHECK_FALSE(state->dirty());
  add_bookmark(*state);
  CHECK(state->dirty());
  state->view.camera.position = {400, 50, 300};
  state->clock.hour = 20;
  state->clock.month = 0;
  go_to_bookmark(*state, 0);
  CHECK(state->clock.hour == 6.5);
  CHECK(state->clock.month == 9);
  arrive(*state);
  CHECK(state->view.camera.position == glm::dvec3(100, 200, 80));
  go_to_bookmark(*state, 7);
  CHECK_FALSE(state->exploring.flight);
}

TEST_CASE("bookmarks are renamed, brought up to date and deleted") {
  const auto state = editor();
  add_bookmark(*state);
  add_bookmark(*state);
  rename_bookmark(*state, 0, "The ford");
  rename_bookmark(*state, 1, "");
  CHECK(state->views.bookmarks[0].name == "The ford");
  CHECK(state->views.bookmarks[1].name == "View 2");
  state->view.camera.position = {1, 2, 30};
  update_bookmark(*state, 0);
  CHECK(state->views.bookmarks[0].camera.position == glm::dvec3(1, 2, 30));
  CHECK(state->views.bookmarks[0].name == "The ford");
  delete_bookmark(*state, 0);
  REQUIRE(state->views.bookmarks.size() == 1);
  CHECK(state->views.bookmarks[0].name == "View 2");
}

TEST_CASE("views of a path keep their order whatever moment is asked for") {
  const auto state = editor();
  for (int i = 0; i < 3; ++i) add_path_key(*state);
  const auto& keys = state->views.path.keys;
  REQUIRE(keys.size() == 3);
  CHECK(keys[2].seconds == Approx(2 * seconds_between_keys));
  set_path_key_seconds(*state, 1, 500);
  CHECK(keys[1].seconds < keys[2].seconds);
  set_path_key_seconds(*state, 1, -5);
  CHECK(keys[1].seconds > keys[0].seconds);
  delete_path_key(*state, 1);
  CHECK(keys.size() == 2);
}

TEST_CASE("a path that is played moves camera and clock, and ends at its end") {
  const auto state = editor();
  add_path_key(*state);
  state->view.camera.position = {300, 400, 90};
  add_path_key(*state);
  state->pictures.day_passes = true;
  state->pictures.hours = {6, 18};
  set_path_day(*state);
  play_path(*state);
  REQUIRE(advance_path(*state, 0.5 * seconds_between_keys));
  CHECK(state->view.camera.position.x == Approx(200).margin(1));
  CHECK(state->clock.hour == Approx(12));
  CHECK_FALSE(advance_path(*state, seconds_between_keys));
  CHECK(state->pictures.playing < 0);
}

TEST_CASE("taking the camera by hand ends what moved it") {
  const auto state = editor();
  add_path_key(*state);
  add_path_key(*state);
  play_path(*state);
  take_camera(*state);
  CHECK(state->pictures.playing < 0);
  state->exploring.following = true;
  take_camera(*state);
  CHECK_FALSE(state->exploring.following);
}

TEST_CASE("a followed place carries the camera along, however it was turned") {
  const auto state = editor();
  state->exploring.following = true;
  state->exploring.followed = glm::dvec3(120, 230, 20);
  advance_exploring(*state, 0.1);
  const glm::dvec3 arm = state->view.camera.position - glm::dvec3(120, 230, 20);
  state->exploring.followed = glm::dvec3(180, 240, 24);
  CHECK(advance_exploring(*state, 0.1));
  CHECK(glm::length(state->view.camera.position - glm::dvec3(180, 240, 24) - arm) < 1e-9);
  // Seen from elsewhere by hand: from there it goes on.
  state->view.camera.position += glm::dvec3(0, -20, 10);
  keep_arm(*state);
  const glm::dvec3 before = state->view.camera.position;
  CHECK_FALSE(advance_exploring(*state, 0.1));
  CHECK(state->view.camera.position == before);
}

TEST_CASE("walking begins at eye height where one is, and on foot again means flying") {
  const auto state = editor();
  state->view.camera.position = {105, 205, 40};
  set_walking(*state, true);
  arrive(*state);
  CHECK(state->exploring.walking);
  const double ground = double(ground_height(state->shown->terrain(), 105, 205));
  CHECK(state->view.camera.position.x == Approx(105));
  CHECK(state->view.camera.position.z == Approx(ground + 1.7));
  set_walking(*state, false);
  CHECK_FALSE(state->exploring.walking);
}

TEST_CASE("an order along a path looks at each moment from where the path is then, above the ground") {
  PictureOrder order;
  order.snapshot = small_landscape();
  Camera camera;
  camera.position = {100, 300, -500};
  set_key(order.path, {0, camera});
  camera.position = {300, 300, 500};
  set_key(order.path, {2, camera});
  order.path.hours = {10, 12};
  order.options.seconds = 7;
  order.frames_a_second = 10;
  CHECK(picture_count(order) == 21);
  const PictureView first = picture_view(order, 0);
  CHECK(first.camera.position.z > 0);
  CHECK(first.options.hour == Approx(10));
  const PictureView middle = picture_view(order, 10);
  CHECK(middle.camera.position.x == Approx(200));
  CHECK(middle.options.hour == Approx(11));
  CHECK(middle.options.seconds == Approx(8));
}

TEST_CASE("a key between two that are close to each other stays where it is") {
  const auto state = editor();
  for (const double seconds : {0.0, 0.05, 0.1}) state->views.path.keys.push_back({seconds, state->view.camera});
  set_path_key_seconds(*state, 1, 3);
  CHECK(state->views.path.keys[1].seconds == 0.05);
  CHECK_FALSE(state->dirty());
  set_path_key_seconds(*state, 2, 3);
  set_path_key_seconds(*state, 1, 7);
  CHECK(state->views.path.keys[1].seconds == Approx(2.9));
}

TEST_CASE("views that could not be read stay as they are until somebody changes one") {
  const auto state = editor();
  state->views.unread = "{\"from\": \"tomorrow\"}";
  CHECK(saved_views_to_json(state->views) == state->views.unread);
  add_bookmark(*state);
  CHECK(state->views.unread.empty());
  CHECK(saved_views_to_json(state->views).find("View 1") != std::string::npos);
  rename_bookmark(*state, 0, std::string(500, 'a'));
  CHECK(state->views.bookmarks[0].name.size() == most_name_bytes);
}
