#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
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
  place_tile(whole, pixels, {0, 0, 2, 1}, {0, 0, 2, 1});
  CHECK(whole.rgba[24] == 1);
  CHECK(whole.rgba[28] == 2);
  CHECK(whole.rgba[0] == 0);
}

TEST_CASE("what is drawn around a tile ends at the picture, and only the tile of it is taken") {
  const PictureTile tile{2, 1, 1, 1};
  const PictureTile drawn = with_margin(tile, 2, 4, 3);
  CHECK(drawn.x == 0);
  CHECK(drawn.y == 0);
  CHECK(drawn.width == 4);
  CHECK(drawn.height == 3);
  Image pixels{4, 3, std::vector<std::uint8_t>(48, 0)};
  pixels.rgba[4 * (1 * 4 + 2)] = 7;
  Image whole{4, 3, std::vector<std::uint8_t>(48, 1)};
  place_tile(whole, pixels, tile, drawn);
  CHECK(whole.rgba[4 * (1 * 4 + 2)] == 7);
  CHECK(std::count(whole.rgba.begin(), whole.rgba.end(), 1) == 44);
}

namespace {

/// A wood and a meadow on both sides of a river, drawn by one renderer.
struct TiledPicture {
  static constexpr int width = 320;
  static constexpr int height = 200;
  std::unique_ptr<LandscapeRenderer> renderer;
  PictureOrder order = order_of("x.png");

  bool make(float quality) {
    auto made = LandscapeRenderer::create();
    REQUIRE(made);
    renderer = std::move(*made);
    const auto wooded = test::level_landscape();
    test::cover(*wooded, 0, 0.25F);
    test::cover(*wooded, 2, 0.1F);
    test::cover(*wooded, 3, 0.6F);
    wooded->hydrology = test::river(62, 66);
    order.snapshot = wooded;
    order.options.quality = quality;
    // Over the river, along which trees stand on both sides.
    order.camera.position = {272, 200, 103};
    order.camera.heading = 330;
    order.camera.pitch = -8;
    renderer->set_snapshot(order.snapshot);
    renderer->finish_loading(order.camera, order.options);
    return true;
  }
  [[nodiscard]] Image at_once() const {
    const RenderTarget target(width, height);
    target.bind();
    renderer->draw(order.camera, order.options, width, height);
    return target.read();
  }
  [[nodiscard]] Image in_tiles(int side, int margin) const {
    Image whole{width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 4, 0)};
    for (int i = 0; i < tile_count(width, height, side); ++i) {
      const PictureTile tile = picture_tile(width, height, side, i);
      const PictureTile drawn = with_margin(tile, margin, width, height);
      const RenderTarget part(drawn.width, drawn.height);
      part.bind();
      LandscapeOptions options = order.options;
      options.corner = {drawn.x, drawn.y};
      renderer->draw(order.camera, options, width, height);
      place_tile(whole, part.read(), tile, drawn);
    }
    return whole;
  }
};

/// Share of pixels that differ by more than a hair: of all, and of those within two pixels of a tile's edge.
struct Differences {
  double all = 0;
  double at_seams = 0;
};
Differences differences(const Image& a, const Image& b, int side) {
  int all = 0;
  int seams = 0;
  int at_seams = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const std::size_t at = 4 * (std::size_t(y) * std::size_t(a.width) + std::size_t(x));
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a.rgba[at + c]) - int(b.rgba[at + c])));
      const int row = a.height - 1 - y;
      const bool seam = (x + 2) % side < 4 || (row + 2) % side < 4;
      seams += seam ? 1 : 0;
      if (most <= 3) continue;
      ++all;
      at_seams += seam ? 1 : 0;
    }
  }
  return {double(all) / (double(a.width) * a.height), double(at_seams) / std::max(seams, 1)};
}

}  // namespace

TEST_CASE("a picture drawn in tiles is the one drawn at once, with all effects and without a seam") {
  const auto context = OffscreenContext::create();
  if (!context) {
    WARN("No OpenGL here: " << context.error().message);
    return;
  }
  const float quality = GENERATE(0.5F, 2.0F, 4.0F);
  CAPTURE(quality);
  TiledPicture picture;
  REQUIRE(picture.make(quality));
  constexpr int side = 96;
  const Image once = picture.at_once();
  const int margin = tile_margin(picture.order.options, TiledPicture::height);
  CHECK((margin > 0) == (quality >= 2));
  // Where a leaf's edge lies a hair beside a pixel's middle, rounding may put it on the other side.
  const Differences tiled = differences(once, picture.in_tiles(side, margin), side);
  CHECK(tiled.all < 0.004);
  CHECK(tiled.at_seams < 0.008);
  if (quality >= 2) {
    // Effects are there, and need the margin.
    CHECK(differences(once, picture.in_tiles(side, 0), side).at_seams > 0.02);
    picture.order.options.smooth_edges = picture.order.options.occlusion = picture.order.options.reflections = false;
    CHECK(differences(once, picture.at_once(), side).all > 0.05);
  }
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < once.rgba.size(); i += 4)
    colours.insert(once.rgba[i] | once.rgba[i + 1] << 8U | once.rgba[i + 2] << 16U);
  CHECK(colours.size() > 20);
}

TEST_CASE("what water mirrors is the same in every tile") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  TiledPicture picture;
  REQUIRE(picture.make(2));
  picture.order.options.smooth_edges = false;
  const Image once = picture.at_once();
  // Tiles so small that none holds what it mirrors.
  CHECK(differences(once, picture.in_tiles(40, 0), 40).all < 0.004);
  picture.order.options.reflections = false;
  CHECK(differences(once, picture.at_once(), 40).all > 0.01);
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
