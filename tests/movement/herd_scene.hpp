#pragma once

#include <memory>
#include <vector>

#include "core/base/random.hpp"
#include "core/movement/herd_simulation.hpp"
#include "tests/movement/movement_scene.hpp"

namespace biotope::test {

inline AnimalTraits herd_traits(float speed, float length, float shoulder) {
  AnimalTraits traits;
  traits.mass_min = 80;
  traits.mass_max = 120;
  traits.speed = speed;
  traits.max_slope = 0.8F;
  traits.wade_depth = 0.6F;
  traits.activity = Activity::diurnal;
  traits.water_visits = 2;
  traits.growth_rate = 0.3F;
  traits.shape.body_length = length;
  traits.shape.shoulder_height = shoulder;
  return traits;
}

/// Trunks on a lattice with jitter; no shore of its own.
class Grove : public HerdDetails {
 public:
  explicit Grove(double spacing, int shift = 0) : spacing_(spacing), shift_(shift) {}
  [[nodiscard]] std::optional<float> shore(Place) const override { return std::nullopt; }
  void stems(Place low, Place high, std::vector<Stem>& stems) const override {
    for (int y = int(std::floor(low.y / spacing_)) - 1; y <= int(std::ceil(high.y / spacing_)); ++y) {
      for (int x = int(std::floor(low.x / spacing_)) - 1; x <= int(std::ceil(high.x / spacing_)); ++x) {
        const Stem stem = this->stem(x, y);
        if (stem.at.x >= low.x && stem.at.x < high.x && stem.at.y >= low.y && stem.at.y < high.y) stems.push_back(stem);
      }
    }
  }
  [[nodiscard]] bool same_within(const HerdDetails& other, Place, Place) const override {
    const auto* grove = dynamic_cast<const Grove*>(&other);
    return grove != nullptr && grove->spacing_ == spacing_ && grove->shift_ == shift_;
  }

 private:
  [[nodiscard]] Stem stem(int x, int y) const {
    const auto unit = [&](std::uint64_t what) {
      return random_unit({std::uint64_t(shift_), std::uint64_t(x + 1000), std::uint64_t(y + 1000), what});
    };
    return {{(x + 0.2 + 0.6 * unit(1)) * spacing_, (y + 0.2 + 0.6 * unit(2)) * spacing_}, 0.12 + 0.25 * unit(3)};
  }
  double spacing_;
  int shift_;
};

/// 1.5 km of meadow with a deep pool in the middle that has shallow banks, herds of deer around it and a pack of wolves that
/// follows one. Few `pastures`: herds share them. `deepened` is a cell beyond the pool that has deep water as well.
inline std::shared_ptr<HerdWorld> meadow(int pastures = 6, std::shared_ptr<const HerdDetails> details = nullptr,
                                         std::pair<int, int> deepened = {-1, -1}) {
  MovementScene scene(150, 120, 10, [](int x, int y) { return 0.4F * float(y) + 0.02F * float(x); });
  Hydrology hydrology;
  hydrology.water_depth = Grid<float>(150, 120);
  for (int y = 40; y < 70; ++y) {
    for (int x = 60; x < 85; ++x) {
      const bool edge = y == 40 || y == 69 || x == 60 || x == 84;
      hydrology.water_depth(x, y) = edge ? 0.3F : 3.0F;
      scene.blocked(x, y) = !edge;
    }
  }
  if (deepened.first >= 0) hydrology.water_depth(deepened.first, deepened.second) = 3;
  scene.ground.hydrology = std::make_shared<const Hydrology>(std::move(hydrology));
  const int deer = scene.animal("deer", 1, herd_traits(1.4F, 2.0F, 1.2F), {0});
  const int wolf = scene.animal("wolf", 2, herd_traits(2.2F, 1.2F, 0.7F), {deer});
  std::vector<ResourceNode> nodes{MovementScene::node(NodeKind::bank, 59, 55, 1500, 0),
                                  MovementScene::node(NodeKind::bank, 85, 50, 1500, 0)};
  const std::vector<ResourceNode> banks = nodes;
  for (int i = 0; i < pastures; ++i)
    nodes.push_back(MovementScene::node(NodeKind::vegetation, 15 + 22 * i, 15 + (i * 47) % 90, 40000, 1500));
  AnimalLevel grazers = scene.level(1, nodes);
  for (const int size : {1, 12, 30, 90}) grazers.herds.push_back({deer, 0, size});
  scene.add(std::move(grazers));
  nodes = banks;
  nodes.push_back(MovementScene::node(NodeKind::prey, 40, 80, 1e6, 5000, deer));
  AnimalLevel hunters = scene.level(2, nodes, 8);
  hunters.herds = {{wolf, 0, 6}};
  scene.add(std::move(hunters));

  auto world = std::make_shared<HerdWorld>();
  world->web = std::make_shared<const FoodWeb>(scene.web);
  world->ground = scene.ground;
  world->levels = scene.levels;
  auto graph = std::make_shared<ResourceAccessGraph>();
  graph->levels.resize(1);
  for (const auto& level : scene.levels) graph->levels.push_back(*level->graph);
  world->graph = graph;
  world->plans = std::make_shared<const std::vector<DailyPlan>>(scene.plans());
  world->seed = 7;
  world->details = std::move(details);
  return world;
}

inline bool same(const HerdAnimal& a, const HerdAnimal& b) {
  return a.place == b.place && a.heading == b.heading && a.speed == b.speed && a.cycles == b.cycles &&
         a.head_down == b.head_down && a.lying == b.lying;
}

inline std::vector<HerdRequest> all_herds(const HerdWorld& world) {
  std::vector<HerdRequest> requests;
  for (std::size_t p = 0; p < world.plans->size(); ++p) requests.push_back({int(p), 1});
  return requests;
}

}  // namespace biotope::test
