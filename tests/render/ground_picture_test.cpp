#include "render/ground_picture.hpp"

#include "core/base/last_owner.hpp"
#include "render/ground_maker.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

const glm::vec3 morning = glm::normalize(glm::vec3(0.7F, -0.3F, 0.6F));

template <class Texel>
bool equal(const TexelPyramid<Texel>& a, const TexelPyramid<Texel>& b) {
  return a.levels == b.levels;
}

/// To the bit.
bool equal(const GroundPicture& a, const GroundPicture& b) {
  return a.coarse == b.coarse && a.shape->surface == b.shape->surface && a.shape->bounds.whole() == b.shape->bounds.whole() &&
         equal(a.shape->heights, b.shape->heights) && equal(a.shape->normals, b.shape->normals) &&
         a.lines->shore->codes == b.lines->shore->codes && a.lines->near_water == b.lines->near_water &&
         equal(a.lines->lines, b.lines->lines) && equal(a.lines->currents, b.lines->currents) &&
         bool(a.lines->trails) == bool(b.lines->trails) && (!a.lines->trails || *a.lines->trails == *b.lines->trails) &&
         equal(a.tints->ground, b.tints->ground) && equal(a.tints->canopy, b.tints->canopy) &&
         equal(a.light->sunlit, b.light->sunlit);
}

std::shared_ptr<MapsSnapshot> hilly_landscape() {
  auto snapshot = level_landscape();
  auto terrain = std::make_shared<Terrain>(snapshot->terrain());
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) terrain->height(x, y) = 100 + 30 * std::sin(float(x) / 9) * std::cos(float(y) / 13);
  }
  snapshot->document.terrain = terrain;
  snapshot->hydrology = river(60, 64);
  cover(*snapshot, 0, {0, 0, cells, 60}, 0.5F);
  cover(*snapshot, 3, 0.4F);
  return snapshot;
}

std::shared_ptr<const TrailNetwork> one_trail(int row) {
  auto trails = std::make_shared<TrailNetwork>();
  trails->wear = Grid<float>(cells, cells, 0);
  trails->carving = Grid<float>(cells, cells, 0);
  TrailRoute route;
  for (int x = 0; x < cells; ++x) {
    trails->wear(x, row) = 0.8F;
    trails->carving(x, row) = 0.2F;
    route.points.push_back({float(x), float(row)});
    route.weight.push_back(1);
  }
  trails->routes.push_back(route);
  return trails;
}

/// A landscape and what may become of it: paint, trails, another month, another hour, a species hidden.
std::vector<GroundRequest> history() {
  const auto first = hilly_landscape();
  const auto painted = std::make_shared<MapsSnapshot>(*first);
  cover(*painted, 1, {10, 70, 30, 90}, 0.7F);
  const auto walked = std::make_shared<MapsSnapshot>(*painted);
  walked->trails = one_trail(20);
  const auto elsewhere = std::make_shared<MapsSnapshot>(*walked);
  elsewhere->trails = one_trail(100);
  const glm::vec3 evening = glm::normalize(glm::vec3(-0.9F, -0.2F, 0.2F));
  return {{first, 5, {}, morning},
          {painted, 5, {}, morning},
          {walked, 5, {}, morning},
          {elsewhere, 5, {}, morning},
          {elsewhere, 9, {}, morning},
          {elsewhere, 9, {}, evening},
          {elsewhere, 9, {true, false, true, true}, evening},
          {first, 5, {}, morning}};
}

}  // namespace

TEST_CASE("a picture that takes over what it can is the one made from nothing, to the bit") {
  std::shared_ptr<const GroundPicture> before;
  for (const GroundRequest& request : history()) {
    const auto taking_over = make_ground(request, before.get());
    CHECK(equal(*taking_over, *make_ground(request, nullptr)));
    before = taking_over;
  }
}

TEST_CASE("a picture made in the background is the one made in the foreground, to the bit") {
  GroundMaker maker;
  for (const GroundRequest& request : history()) {
    maker.request(request);
    maker.wait_idle();
    CHECK_FALSE(maker.busy());
    const auto made = maker.take();
    REQUIRE(made);
    CHECK(equal(*made, *make_ground(request, nullptr)));
    CHECK(maker.take() == nullptr);
  }
}

TEST_CASE("of many requests the newest is the one that is answered") {
  GroundMaker maker;
  const auto snapshot = hilly_landscape();
  for (int month = 0; month < 12; ++month) maker.request({snapshot, month, {}, morning});
  maker.wait_idle();
  const auto made = maker.take();
  REQUIRE(made);
  CHECK(made->of.month == 11);
}

TEST_CASE("paint in one corner makes new tiles there and nowhere else") {
  const std::vector<GroundRequest> steps = history();
  const auto before = make_ground(steps[0], nullptr);
  const auto after = make_ground(steps[1], before.get());
  CHECK(after->shape == before->shape);
  CHECK(after->lines == before->lines);
  CHECK(after->light == before->light);
  const TiledMap<Rgba>& now = after->tints->ground.levels.front();
  const TiledMap<Rgba>& then = before->tints->ground.levels.front();
  REQUIRE(now.tile_count() == 4);
  CHECK(now.tile(0) == then.tile(0));
  CHECK(now.tile(1) == then.tile(1));
  CHECK(now.tile(2) != then.tile(2));  // columns 10 to 30, rows 70 to 90
  CHECK(now.tile(3) == then.tile(3));
}

TEST_CASE("a large ground of another extent has a coarse picture at first, and the real one follows") {
  auto snapshot = hilly_landscape();
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(600, 520, 50);
  terrain->cell_size = 4;
  auto large = std::make_shared<MapsSnapshot>();
  large->document.terrain = terrain;
  const auto coarse = make_coarse_ground({large, 5, {}, morning});
  CHECK(coarse->coarse);
  CHECK(coarse->shape->surface.width() == 300);
  CHECK(coarse->tints->ground.levels.front().height() == 260);
  GroundMaker maker;
  maker.request({snapshot, 5, {}, morning});
  maker.request({large, 5, {}, morning});
  maker.wait_idle();
  const auto made = maker.take();
  REQUIRE(made);
  CHECK_FALSE(made->coarse);
  CHECK(made->shape->surface.width() == 600);
}

TEST_CASE("a stopped picture is none") {
  std::stop_source stop;
  stop.request_stop();
  CHECK(make_ground(history().front(), nullptr, stop.get_token()) == nullptr);
}

TEST_CASE("a mipmap's texel is the mean of the four under it, down to one texel") {
  Grid<Rg> texels(6, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 6; ++x) texels(x, y) = {std::uint8_t(10 * x), std::uint8_t(100 * (y % 2))};
  }
  TexelPyramid<Rg> pyramid;
  pyramid.levels.push_back(shared_tiles<Rg>(texels, nullptr));
  add_mipmaps<Rg>(pyramid, nullptr);
  REQUIRE(pyramid.levels.size() == 3);
  CHECK(pyramid.levels[1].rect() == Rect{0, 0, 3, 1});
  CHECK(pyramid.levels[1](0, 0) == Rg{5, 50});
  CHECK(pyramid.levels[1](2, 0) == Rg{45, 50});
  CHECK(pyramid.levels[2](0, 0) == Rg{15, 50});
  CHECK(mipmaps(texels).back()(0, 0) == Rg{15, 50});
}

TEST_CASE("what others still hold is not given up") {
  LastOwner owner;
  auto held = std::make_shared<const int>(1);
  const std::weak_ptr<const int> watch = held;
  owner.keep(held);
  CHECK(owner.take_unused().empty());
  held.reset();
  CHECK_FALSE(watch.expired());
  CHECK(owner.take_unused().size() == 1);
  CHECK(watch.expired());
  CHECK(owner.empty());
}
