#include "render/plant_model_maker.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "render/ground_maps.hpp"
#include "render/plant_mesh_order.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

namespace {

ModelMeshes make_meshes(const PlantTraits& plant, std::uint64_t seed) {
  ModelMeshes meshes;
  if (plant.stratum != Stratum::herb) meshes.close = ordered(make_plant_mesh(plant.shape, PlantDetail::close, seed));
  meshes.near = ordered(make_plant_mesh(plant.shape, PlantDetail::near, seed));
  meshes.mid = ordered(make_plant_mesh(plant.shape, PlantDetail::mid, seed));
  return meshes;
}

}  // namespace

OrderedMesh ordered(const PlantMesh& mesh) {
  return {mesh.vertices, ordered_indices(mesh), mesh.indices.size(), extent_of(mesh)};
}

std::shared_ptr<const PlantModels> make_plant_models(std::shared_ptr<const FoodWeb> web) {
  auto models = std::make_shared<PlantModels>();
  models->web = std::move(web);
  const FoodWeb& of = *models->web;
  if (of.levels.empty()) return models;
  const std::size_t count = std::min<std::size_t>(of.levels[0].size(), most_plant_kinds);
  models->meshes.resize(count * plant_models);
  parallel_each(models->meshes.size(), [&](std::size_t i) {
    models->meshes[i] = make_meshes(of.species[std::size_t(of.levels[0][i / plant_models])].plant(), 0x6b696e64ULL + i);
  });
  return models;
}

void PlantModelMaker::start(std::shared_ptr<const FoodWeb> web) {
  work_ = std::make_shared<Work>();
  ended_ = thread_.start([work = work_, web = std::move(web)] { work->made = make_plant_models(web); });
}

std::shared_ptr<const PlantModels> PlantModelMaker::take(std::chrono::steady_clock::time_point until) {
  if (!work_) return nullptr;
  constexpr auto ever = std::chrono::steady_clock::time_point::max();
  if (until == ever) ended_.wait();
  if (until != ever && ended_.wait_until(until) != std::future_status::ready) return nullptr;
  ended_.get();
  return std::exchange(work_, nullptr)->made;
}

}  // namespace biotope
