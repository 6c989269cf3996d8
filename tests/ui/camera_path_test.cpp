#include <catch2/catch.hpp>
#include <cmath>

#include "tests/ui/small_landscape.hpp"
#include "ui/camera_flight.hpp"
#include "ui/camera_path.hpp"
#include "ui/saved_views.hpp"

using namespace biotope;

namespace {

Camera camera(double x, double y, double z, float heading) {
  Camera made;
  made.position = {x, y, z};
  made.heading = heading;
  return made;
}

CameraPath bend() {
  CameraPath path;
  set_key(path, {0, camera(0, 0, 10, 350)});
  set_key(path, {4, camera(100, 0, 20, 10)});
  set_key(path, {6, camera(100, 80, 30, 90)});
  return path;
}

}  // namespace

TEST_CASE("a path goes through every one of its views at its moment") {
  const CameraPath path = bend();
  for (const CameraKey& key : path.keys) {
    const Camera now = camera_on_path(path, key.seconds);
    CHECK(glm::length(now.position - key.camera.position) < 1e-6);
    CHECK(std::abs(shortest_turn(now.heading, key.camera.heading)) < 1e-3F);
  }
}

TEST_CASE("a path neither jumps nor turns the long way") {
  const CameraPath path = bend();
  Camera before = camera_on_path(path, 0);
  for (int i = 1; i <= 600; ++i) {
    const Camera now = camera_on_path(path, i / 100.0);
    CHECK(glm::length(now.position - before.position) < 1.0);
    CHECK(std::abs(shortest_turn(before.heading, now.heading)) < 1.0F);
    before = now;
  }
  // Through north, not through south.
  const float middle = camera_on_path(path, 2).heading;
  CHECK((middle > 340 || middle < 20));
}

TEST_CASE("between views of an even flight the camera is where it would be by its speed") {
  CameraPath path;
  for (int i = 0; i < 5; ++i) set_key(path, {double(i), camera(10.0 * i, 5, 7, 30)});
  for (const double seconds : {0.25, 1.5, 2.75, 3.9}) CHECK(camera_on_path(path, seconds).position.x == Approx(10 * seconds));
}

TEST_CASE("before a path's beginning and after its end the camera stands") {
  const CameraPath path = bend();
  CHECK(camera_on_path(path, -3).position == path.keys.front().camera.position);
  CHECK(camera_on_path(path, 100).position == path.keys.back().camera.position);
  CHECK(path_seconds(path) == Approx(6));
  CHECK(frame_count(path, 25) == 151);
  CHECK(frame_count({}, 25) == 0);
}

TEST_CASE("keys stand in their order, and one at the same moment is replaced") {
  CameraPath path;
  set_key(path, {4, camera(4, 0, 0, 0)});
  set_key(path, {1, camera(1, 0, 0, 0)});
  set_key(path, {4.001, camera(5, 0, 0, 0)});
  REQUIRE(path.keys.size() == 2);
  CHECK(path.keys[0].seconds == 1);
  CHECK(path.keys[1].camera.position.x == 5);
}

TEST_CASE("the day passes along a path, over midnight too") {
  CameraPath path = bend();
  CHECK(hour_on_path(path, 3, 10.5) == 10.5);
  path.hours = {6, 18};
  CHECK(hour_on_path(path, 3, 0) == Approx(12));
  path.hours = {20, 4};
  CHECK(hour_on_path(path, 0, 0) == Approx(20));
  CHECK(hour_on_path(path, 6, 0) == Approx(4));
  CHECK(hour_on_path(path, 4.5, 0) == Approx(2));
}

TEST_CASE("a path reads back as it was written") {
  CameraPath path = bend();
  path.hours = {5.5, 21};
  const auto read = parse_path_text(path_to_text(path), "p.json");
  REQUIRE(read);
  REQUIRE(read->keys.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(read->keys[i].seconds == path.keys[i].seconds);
    CHECK(glm::length(read->keys[i].camera.position - path.keys[i].camera.position) < 1e-3);
    CHECK(read->keys[i].camera.heading == path.keys[i].camera.heading);
  }
  CHECK(read->hours == path.hours);
}

TEST_CASE("a path that makes no sense is refused with a message that says where") {
  const std::string view = R"("x": 1, "y": 2, "z": 3, "heading": 0, "pitch": 0)";
  struct Bad {
    std::string text;
    std::string says;
  };
  for (const Bad& bad :
       {Bad{"{", "not valid JSON"}, Bad{"[]", "expected an object"}, Bad{R"({"keys": []})", "at least two views"},
        Bad{R"({"keys": 7})", "a list"}, Bad{R"({"keys": [{"seconds": 0, )" + view + "}]}", "at least two views"},
        Bad{R"({"keys": [{"seconds": 1, )" + view + R"(}, {"seconds": 1, )" + view + "}]}", "key 2"},
        Bad{R"({"keys": [{"seconds": 0, "x": 1}, {}]})", "key 1"},
        Bad{R"({"keys": [{"seconds": "soon", )" + view + "}]}", "seconds"},
        Bad{R"({"keys": [{"seconds": 0, "pich": 2, )" + view + "}]}", "did you mean \"pitch\""},
        Bad{R"({"keys": [{"seconds": 0, )" + view + R"(}, {"seconds": 2, )" + view + R"(}], "hours": [4]})", "hours"},
        Bad{R"({"keys": [{"seconds": 0, )" + view + R"(}, {"seconds": 1e9, )" + view + "}]}", "seconds"}}) {
    CAPTURE(bad.text);
    const auto read = parse_path_text(bad.text, "p.json");
    REQUIRE_FALSE(read);
    CHECK(read.error().message.find("p.json") == 0);
    CHECK(read.error().message.find(bad.says) != std::string::npos);
  }
}

TEST_CASE("bookmarks and path survive being saved") {
  SavedViews views;
  CHECK(saved_views_to_json(views).empty());
  views.bookmarks = {{"The ford \"at dawn\"", camera(12.3456, -7, 88, 271.5F), 5.25, 0},
                     {"Überblick", camera(0, 0, 900, 0), 12, 11}};
  views.path = bend();
  std::vector<std::string> problems;
  const SavedViews read = read_saved_views(saved_views_to_json(views), "views.json", problems);
  CHECK(problems.empty());
  CHECK(read.unread.empty());
  REQUIRE(read.bookmarks.size() == 2);
  CHECK(read.bookmarks[0].name == views.bookmarks[0].name);
  CHECK(read.bookmarks[0].hour == 5.25);
  CHECK(read.bookmarks[0].month == 0);
  CHECK(read.bookmarks[0].camera.heading == 271.5F);
  CHECK(glm::length(read.bookmarks[0].camera.position - views.bookmarks[0].camera.position) < 1e-3);
  CHECK(read.bookmarks[1].name == "Überblick");
  CHECK(read.bookmarks[1].month == 11);
  CHECK(read.path.keys.size() == 3);
  CHECK(read_saved_views("", "views.json", problems).empty());
  CHECK(problems.empty());
}

TEST_CASE("a bookmark that makes no sense takes no other with it, and its text stays") {
  const std::string good = R"({"name": "Ford", "x": 1, "y": 2, "z": 3, "heading": 0, "pitch": 0})";
  const std::string newer = R"({"name": "Newer", "x": 1, "y": 2, "z": 3, "heading": 0, "pitch": 0, "lens": "wide"})";
  struct Damaged {
    std::string text;
    std::size_t bookmarks;
    std::string says;
  };
  for (const Damaged& damaged :
       {Damaged{"{", 0, "not valid JSON"}, Damaged{R"({"bokmarks": []})", 0, "bokmarks"},
        Damaged{R"({"bookmarks": 7})", 0, "a list"}, Damaged{R"({"bookmarks": [{"name": ""}, )" + good + "]}", 1, "bookmark 1"},
        Damaged{R"({"bookmarks": [)" + newer + ", " + good + "]}", 2, "lens"},
        Damaged{R"({"bookmarks": [)" + good + R"(], "path": {"keys": 3}})", 1, "path"},
        Damaged{R"({"bookmarks": [)" + good + R"(], "weathers": {}})", 1, "weathers"}}) {
    CAPTURE(damaged.text);
    std::vector<std::string> problems;
    const SavedViews read = read_saved_views(damaged.text, "views.json", problems);
    CHECK(read.bookmarks.size() == damaged.bookmarks);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].find("views.json") == 0);
    CHECK(problems[0].find(damaged.says) != std::string::npos);
    CHECK(saved_views_to_json(read) == damaged.text);
  }
}

TEST_CASE("a path of a newer version is read without what is not known of it") {
  const std::string view = R"("x": 1, "y": 2, "z": 3, "heading": 0, "pitch": 0)";
  std::vector<std::string> problems;
  const SavedViews read = read_saved_views(
      R"({"path": {"ease": 1, "keys": [{"seconds": 0, "roll": 4, )" + view + R"(}, {"seconds": 2, )" + view + "}]}}",
      "views.json", problems);
  CHECK(read.path.keys.size() == 2);
  CHECK(problems.size() == 1);
  CHECK_FALSE(read.unread.empty());
}

TEST_CASE("views high over the largest terrains and keys that are close to each other read back") {
  SavedViews views;
  views.bookmarks = {{"Far", camera(4e6, -2e6, 3e6, -725), 12, 0}};
  for (int i = 0; i < 40; ++i) views.path.keys.push_back({0.01 * i + 0.0004, camera(i, 0, 10, 0)});
  std::vector<std::string> problems;
  const SavedViews read = read_saved_views(saved_views_to_json(views), "views.json", problems);
  CHECK(problems.empty());
  REQUIRE(read.bookmarks.size() == 1);
  CHECK(read.bookmarks[0].camera.position.x == 4e6);
  CHECK(read.path.keys.size() == 40);
}

TEST_CASE("a long name is cut between two characters") {
  CHECK(clipped_name("Ford") == "Ford");
  CHECK(clipped_name(std::string(300, 'a')).size() == most_name_bytes);
  std::string umlauts = "x";
  for (int i = 0; i < 150; ++i) umlauts += "ü";
  const std::string cut = clipped_name(umlauts);
  CHECK(cut.size() == most_name_bytes - 1);
  CHECK(umlauts.starts_with(cut));
}

TEST_CASE("a new bookmark gets a name that none has") {
  std::vector<Bookmark> bookmarks{{"View 1", {}, 0, 0}, {"View 3", {}, 0, 0}};
  CHECK(free_bookmark_name(bookmarks) == "View 4");
  CHECK(free_bookmark_name({}) == "View 1");
}

TEST_CASE("a flight begins and ends where it should, and turns the shorter way") {
  CameraFlight flight{camera(0, 0, 50, 350), camera(1000, 0, 60, 20), 0};
  CHECK(camera_on_flight(flight).position == flight.from.position);
  flight.elapsed = flight_seconds / 2;
  const Camera middle = camera_on_flight(flight);
  CHECK(middle.position.x == Approx(500));
  CHECK(middle.position.z > 100);
  CHECK(std::abs(shortest_turn(middle.heading, 5)) < 0.1F);
  flight.elapsed = flight_seconds;
  CHECK(landed(flight));
  CHECK(camera_on_flight(flight).position == flight.to.position);
}

TEST_CASE("a place is looked at from where it can be seen") {
  const auto snapshot = small_landscape();
  const Terrain& terrain = snapshot->terrain();
  const glm::dvec3 place(350, 330, 40);
  const Camera seen = view_of_place(terrain, place, 60, camera(0, 0, 100, 45));
  const glm::dvec3 arm = place - seen.position;
  CHECK(glm::dot(glm::normalize(arm), glm::dvec3(seen.forward())) > 0.999);
  CHECK(glm::length(arm) == Approx(60).margin(10));
}
