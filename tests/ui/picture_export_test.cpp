#include <sys/stat.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <set>

#include "tests/render/sample_plants.hpp"
#include "tests/ui/small_landscape.hpp"
#include "ui/picture_export.hpp"
#include "ui/video_encoder.hpp"

using namespace biotope;

namespace {

struct Scratch {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("biotope-pictures-" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
};

/// A program called ffmpeg, first in PATH while it lives.
struct FakeEncoder {
  std::string before = std::getenv("PATH") != nullptr ? std::getenv("PATH") : "";
  FakeEncoder(const std::filesystem::path& folder, const std::string& script) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << script << "\n";
    ::chmod((folder / "ffmpeg").c_str(), 0755);
    ::setenv("PATH", (folder.string() + ":" + before).c_str(), 1);
  }
  ~FakeEncoder() { ::setenv("PATH", before.c_str(), 1); }
};

CameraPath short_path() {
  CameraPath path;
  Camera camera;
  camera.position = {100, 100, 60};
  set_key(path, {0, camera});
  camera.position = {150, 120, 65};
  camera.heading = 30;
  set_key(path, {0.2, camera});
  return path;
}

PictureOrder order_of(const std::filesystem::path& out) {
  PictureOrder order;
  order.snapshot = small_landscape();
  order.camera.position = {100, 100, 60};
  order.camera.heading = 60;
  order.options.quality = 0.5F;
  order.width = 96;
  order.height = 64;
  order.out = out;
  return order;
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

Status carry_out(PictureOrder order) {
  PictureExporter exporter;
  exporter.start(std::move(order));
  for (int i = 0; i < 20000 && exporter.running(); ++i) {
    exporter.advance(0.05);
    ::usleep(200);
  }
  CHECK_FALSE(exporter.running());
  return exporter.take_result().value_or(fail("no result"));
}

}  // namespace

TEST_CASE("tiles cover a picture once and nothing else") {
  for (const auto& [width, height, side] :
       {std::array{100, 70, 32}, std::array{64, 64, 64}, std::array{7680, 4320, 640}, std::array{5, 5, 9}}) {
    std::int64_t covered = 0;
    std::set<std::pair<int, int>> corners;
    for (int i = 0; i < tile_count(width, height, side); ++i) {
      const PictureTile tile = picture_tile(width, height, side, i);
      CHECK(tile.width > 0);
      CHECK(tile.height > 0);
      CHECK(tile.x + tile.width <= width);
      CHECK(tile.y + tile.height <= height);
      CHECK(corners.insert({tile.x, tile.y}).second);
      covered += std::int64_t(tile.width) * tile.height;
    }
    CHECK(covered == std::int64_t(width) * height);
  }
}

TEST_CASE("tiles lie in the picture with the lowest row at the bottom") {
  Image whole{2, 4, std::vector<std::uint8_t>(32, 0)};
  Image pixels{2, 1, {1, 1, 1, 1, 2, 2, 2, 2}};
  place_tile(whole, pixels, {0, 0, 2, 1});
  CHECK(whole.rgba[24] == 1);
  CHECK(whole.rgba[28] == 2);
  CHECK(whole.rgba[0] == 0);
}

TEST_CASE("a picture drawn in tiles is the one drawn at once") {
  const auto context = OffscreenContext::create();
  if (!context) {
    WARN("No OpenGL here: " << context.error().message);
    return;
  }
  auto renderer = LandscapeRenderer::create();
  REQUIRE(renderer);
  PictureOrder order = order_of("x.png");
  const auto wooded = test::level_landscape();
  test::cover(*wooded, 0, 0.25F);
  test::cover(*wooded, 2, 0.1F);
  test::cover(*wooded, 3, 0.6F);
  wooded->hydrology = test::river(62, 66);
  order.snapshot = wooded;
  order.camera.position = {256, 150, 108};
  order.camera.heading = 10;
  (*renderer)->set_snapshot(order.snapshot);
  (*renderer)->finish_loading(order.camera, order.options);
  const RenderTarget target(96, 64);
  target.bind();
  (*renderer)->draw(order.camera, order.options, 96, 64);
  const Image once = target.read();
  Image whole{96, 64, std::vector<std::uint8_t>(96 * 64 * 4, 0)};
  for (int i = 0; i < tile_count(96, 64, 40); ++i) {
    const PictureTile tile = picture_tile(96, 64, 40, i);
    const RenderTarget part(tile.width, tile.height);
    part.bind();
    LandscapeOptions options = order.options;
    options.corner = {tile.x, tile.y};
    (*renderer)->draw(order.camera, options, 96, 64);
    place_tile(whole, part.read(), tile);
  }
  // Where a leaf's edge lies a hair beside a pixel's middle, rounding may put it on the other side.
  int different = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(whole.rgba[i + c]) - int(once.rgba[i + c])));
    different += most > 2 ? 1 : 0;
  }
  CHECK(different < 96 * 64 / 50);
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < once.rgba.size(); i += 4)
    colours.insert(once.rgba[i] | once.rgba[i + 1] << 8U | once.rgba[i + 2] << 16U);
  CHECK(colours.size() > 20);
}

TEST_CASE("a picture and a path's pictures get onto the disk, whole") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  const Scratch scratch;
  REQUIRE(carry_out(order_of(scratch.path / "one.png")));
  const auto one = read_png(scratch.path / "one.png");
  REQUIRE(one);
  CHECK(one->width == 96);
  CHECK(one->height == 64);
  PictureOrder along = order_of(scratch.path / "frames");
  along.path = short_path();
  REQUIRE(carry_out(along));
  CHECK(picture_count(along) == 6);
  for (int i = 0; i < 6; ++i) CHECK(read_png(scratch.path / "frames" / frame_name(i)));
  CHECK_FALSE(std::filesystem::exists(scratch.path / "frames" / frame_name(6)));
}

TEST_CASE("a picture that was given up leaves nothing behind") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  const Scratch scratch;
  PictureExporter exporter;
  exporter.start(order_of(scratch.path / "one.png"));
  exporter.advance(0);
  CHECK(exporter.running());
  exporter.cancel();
  CHECK_FALSE(exporter.running());
  CHECK_FALSE(exporter.take_result());
  CHECK(std::filesystem::is_empty(scratch.path));
}

TEST_CASE("giving up does not wait for a picture that is being written, and nothing of it is kept") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  const Scratch scratch;
  double seconds = 0;
  {
    PictureExporter exporter;
    PictureOrder order = order_of(scratch.path / "one.png");
    // Takes long to encode, not to draw.
    order.width = order.height = 2600;
    order.options.plants = false;
    exporter.start(order);
    for (int i = 0; i < 20000 && exporter.stage() != "Writing the picture"; ++i) exporter.advance(0);
    REQUIRE(exporter.running());
    const auto begin = std::chrono::steady_clock::now();
    exporter.cancel();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    CHECK_FALSE(exporter.running());
  }
  CHECK(seconds < 0.5);
  CHECK(std::filesystem::is_empty(scratch.path));
}

TEST_CASE("a video that was given up leaves no folder behind") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  const Scratch scratch;
  const FakeEncoder encoder(scratch.path / "bin", "exit 0");
  {
    PictureExporter exporter;
    PictureOrder order = order_of(scratch.path / "flight.mp4");
    order.path = short_path();
    exporter.start(order);
    for (int i = 0; i < 20000 && names_in(scratch.path).size() < 2; ++i) exporter.advance(0);
    REQUIRE(names_in(scratch.path).size() == 2);
  }
  CHECK(names_in(scratch.path) == std::set<std::string>{"bin"});
}

TEST_CASE("what cannot be written is told before the work") {
  const Scratch scratch;
  CHECK_FALSE(check_order(order_of(scratch.path)));
  CHECK_FALSE(check_order(order_of(scratch.path / "none" / "one.png")));
  PictureOrder large = order_of(scratch.path / "one.png");
  large.width = 100000;
  CHECK_FALSE(check_order(large));
  PictureOrder heavy = order_of(scratch.path / "many");
  heavy.path = short_path();
  heavy.width = heavy.height = 12000;
  CHECK_FALSE(check_order(heavy));
  heavy.height = 10000;
  CHECK(check_order(heavy));
  std::ofstream(scratch.path / "file") << "x";
  PictureOrder along = order_of(scratch.path / "file");
  along.path = short_path();
  CHECK_FALSE(check_order(along));
}

TEST_CASE("a video is made by the ffmpeg in the path, and its complaint is passed on") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  const Scratch scratch;
  PictureOrder order = order_of(scratch.path / "flight.mp4");
  order.path = short_path();
  // Pictures of somebody else are neither taken nor removed.
  const std::filesystem::path own = scratch.path / "flight.mp4.frames";
  std::filesystem::create_directories(own);
  for (const char* name : {"frame-00001.png", "frame-00099.png"}) std::ofstream(own / name) << "mine";
  {
    // Its last word is the video; it counts the pictures it was given.
    const FakeEncoder encoder(scratch.path / "bin", R"sh(for last; do :; done
ls "$(dirname "$last")"/frame-*.png | wc -l > "$last")sh");
    REQUIRE(carry_out(order));
    std::ifstream made(scratch.path / "flight.mp4");
    int pictures = 0;
    made >> pictures;
    CHECK(pictures == 6);
    CHECK(names_in(scratch.path) == std::set<std::string>{"bin", "flight.mp4", "flight.mp4.frames"});
    CHECK(std::filesystem::exists(own / "frame-00001.png"));
  }
  const FakeEncoder encoder(scratch.path / "bin2", "echo 'Unknown encoder libx264' >&2; exit 1");
  order.out = scratch.path / "other.mp4";
  const Status refused = carry_out(order);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("Unknown encoder libx264") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(order.out));
  CHECK(names_in(scratch.path) == std::set<std::string>{"bin", "bin2", "flight.mp4", "flight.mp4.frames"});
}

TEST_CASE("without ffmpeg a video is refused at once, and pictures are not") {
  const Scratch scratch;
  const std::string before = std::getenv("PATH") != nullptr ? std::getenv("PATH") : "";
  ::setenv("PATH", scratch.path.c_str(), 1);
  PictureOrder order = order_of(scratch.path / "flight.mp4");
  order.path = short_path();
  const Status refused = check_order(order);
  order.out = scratch.path / "frames";
  const Status possible = check_order(order);
  ::setenv("PATH", before.c_str(), 1);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("ffmpeg") != std::string::npos);
  CHECK(possible);
}
