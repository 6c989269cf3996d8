#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "tests/movement/herd_scene.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Buffers, textures, arrays, framebuffers and programs that are alive in the current context.
int live_objects() {
  int count = 0;
  for (GLuint name = 1; name < 20000; ++name) {
    count += (glIsBuffer(name) ? 1 : 0) + (glIsTexture(name) ? 1 : 0) + (glIsVertexArray(name) ? 1 : 0) +
             (glIsFramebuffer(name) ? 1 : 0) + (glIsProgram(name) ? 1 : 0);
  }
  return count;
}

/// Memory of this process, MB.
double resident_megabytes() {
  std::ifstream status("/proc/self/statm");
  long pages = 0;
  long resident = 0;
  status >> pages >> resident;
  return double(resident) * 4096 / 1e6;
}

/// A meadow with a pool, trees and herds.
std::shared_ptr<MapsSnapshot> living_meadow() {
  const auto world = meadow();
  auto maps = std::make_shared<MapsSnapshot>();
  maps->document.terrain = world->ground.terrain;
  maps->document.seed = world->seed;
  const int width = world->ground.terrain->height.width();
  const int height = world->ground.terrain->height.height();
  auto water = std::make_shared<Hydrology>(*world->ground.hydrology);
  water->water = Grid<WaterKind>(width, height, WaterKind::dry);
  water->discharge = Grid<float>(width, height, 0);
  water->receiver = Grid<std::uint8_t>(width, height, 8);
  for (std::size_t i = 0; i < water->water.size(); ++i)
    water->water[i] = water->water_depth[i] > 0 ? WaterKind::lake : WaterKind::dry;
  maps->hydrology = water;
  maps->web = world->web;
  maps->cover = {std::make_shared<const CoverMap>(width, height, to_cover(0.2F))};
  maps->animals = world->levels;
  maps->graph = world->graph;
  maps->plans = world->plans;
  return maps;
}

void paint_plants(MapsSnapshot& maps, int at, float fraction) {
  CoverMap cover = *maps.cover.front();
  for (int y = at; y < at + 20; ++y) {
    for (int x = at; x < at + 20; ++x) cover.set(x, y, to_cover(fraction));
  }
  maps.cover.front() = std::make_shared<const CoverMap>(std::move(cover));
}

void raise_ground(MapsSnapshot& maps, int at, float metres) {
  auto terrain = std::make_shared<Terrain>(maps.terrain());
  for (int i = 0; i < 20; ++i) terrain->height(at + i, at) += metres;
  maps.land = terrain;
}

void tread_trail(MapsSnapshot& maps, int row) {
  const Grid<float>& height = maps.terrain().height;
  auto trails = std::make_shared<TrailNetwork>();
  trails->wear = Grid<float>(height.width(), height.height(), 0);
  trails->carving = Grid<float>(height.width(), height.height(), 0);
  TrailRoute route;
  for (int x = 0; x < height.width(); ++x) {
    trails->wear(x, row) = 0.8F;
    trails->carving(x, row) = 0.2F;
    route.points.push_back({float(x), float(row)});
    route.weight.push_back(1);
  }
  trails->routes.push_back(route);
  maps.trails = trails;
}

void move_herds(MapsSnapshot& maps, float cells) {
  auto plans = std::make_shared<std::vector<DailyPlan>>(*maps.plans);
  for (DailyPlan& plan : *plans) {
    for (auto& point : plan.way) point.at.x += cells;
  }
  maps.plans = plans;
}

}  // namespace

TEST_CASE("a thousand edits leave nothing behind: neither OpenGL objects nor memory") {
  const auto context = OffscreenContext::create();
  if (!context) {
    WARN("No OpenGL here: " << context.error().message);
    return;
  }
  auto renderer = LandscapeRenderer::create();
  if (!renderer) FAIL(renderer.error().message);
  const RenderTarget target(64, 48);
  target.bind();
  Camera camera;
  LandscapeOptions options;
  options.quality = 0.5F;
  std::shared_ptr<const MapsSnapshot> shown = living_meadow();
  const double ground = double(ground_height(shown->terrain(), 500, 350));
  camera.position = {500, 350, ground + 12};

  // Plants, ground, trails and herds in turn, each upon the one before.
  const auto edit = [&](int number) {
    auto snapshot = std::make_shared<MapsSnapshot>(*shown);
    snapshot->revision = std::uint64_t(number) + 1;
    const int at = number % 90;
    switch (number % 4) {
      case 0:
        paint_plants(*snapshot, at, 0.1F * float(number % 7));
        break;
      case 1:
        raise_ground(*snapshot, at, number % 8 < 4 ? 1.0F : -1.0F);
        break;
      case 2:
        tread_trail(*snapshot, at);
        break;
      default:
        move_herds(*snapshot, number % 8 < 4 ? 1.0F : -1.0F);
    }
    shown = snapshot;
    (*renderer)->set_snapshot(snapshot);
    if (number % 5 == 0) (*renderer)->finish_loading(camera, options);
    (*renderer)->draw(camera, options, 64, 48);
  };
  for (int i = 0; i < 100; ++i) edit(i);
  (*renderer)->finish_loading(camera, options);
  const int objects = live_objects();
  const double megabytes = resident_megabytes();
  const std::size_t instances = (*renderer)->statistics().instance_bytes;
  for (int i = 100; i < 1000; ++i) edit(i);
  (*renderer)->finish_loading(camera, options);
  CHECK(live_objects() <= objects + 4);
  CHECK(resident_megabytes() < megabytes + 25);
  CHECK(double((*renderer)->statistics().instance_bytes) < 1.5 * double(instances) + 1e6);
  CHECK((*renderer)->statistics().animals > 0);
  CHECK(glGetError() == GL_NO_ERROR);
}
