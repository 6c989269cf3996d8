#include <catch2/catch.hpp>

#include "app/command_line_options.hpp"

using namespace biotope;

TEST_CASE("a RAW layout is read from its short form") {
  const auto plain = parse_raw_layout("640x480:uint16");
  REQUIRE(plain);
  CHECK(plain->width == 640);
  CHECK(plain->height == 480);
  CHECK(plain->sample_type == "uint16");
  CHECK_FALSE(plain->big_endian);
  CHECK(plain->header_bytes == 0);
  const auto full = parse_raw_layout("3x2:float32:big:header=128");
  REQUIRE(full);
  CHECK(full->big_endian);
  CHECK(full->header_bytes == 128);
  for (const char* wrong : {"", "3x2", "3:uint8", "3xy:uint8", "3x2:uint8:small", "3x2:uint8:header=", "3x2x1:uint8"}) {
    INFO(wrong);
    CHECK_FALSE(parse_raw_layout(wrong));
  }
}

TEST_CASE("a crop gives a rectangle of cells") {
  const auto crop = parse_crop("10,20,30,40");
  REQUIRE(crop);
  CHECK(*crop == Rect{10, 20, 40, 60});
  for (const char* wrong : {"", "1,2,3", "1,2,3,4,5", "-1,2,3,4", "1,2,1,4", "a,b,c,d", "1,2,3,99999999999"}) {
    INFO(wrong);
    CHECK_FALSE(parse_crop(wrong));
  }
}

TEST_CASE("a picture's size has two sides in pixels") {
  const auto size = parse_picture_size("1920x1080");
  REQUIRE(size);
  CHECK(size->width == 1920);
  CHECK(size->height == 1080);
  for (const char* wrong : {"", "1920", "1920x", "0x10", "8x8", "20000x20", "1920 x 1080", "-20x20"}) {
    INFO(wrong);
    CHECK_FALSE(parse_picture_size(wrong));
  }
}

TEST_CASE("a camera is five numbers") {
  const auto camera = parse_camera("-10.5,200,1e3,270,-12");
  REQUIRE(camera);
  CHECK(camera->camera.position == glm::dvec3(-10.5, 200, 1000));
  CHECK(camera->camera.heading == 270);
  CHECK(camera->camera.pitch == -12);
  CHECK_FALSE(camera->above_ground);
  const auto standing = parse_camera("10,20,+1.7,0,0");
  REQUIRE(standing);
  CHECK(standing->above_ground);
  CHECK(standing->camera.position.z == 1.7);
  for (const char* wrong : {"", "1,2,3,4", "1,2,3,4,5,6", "1,2,x,4,5", "1,2,nan,4,5", "1,2,3,4,inf"}) {
    INFO(wrong);
    CHECK_FALSE(parse_camera(wrong));
  }
}
