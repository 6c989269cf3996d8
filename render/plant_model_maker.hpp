#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <vector>

#include "core/base/background_thread.hpp"
#include "core/species/species_library.hpp"
#include "render/plant_mesh.hpp"

namespace biotope {

/// Models of each woody kind; which of them a plant is follows from its tint.
inline constexpr int plant_models = 2;

/// A mesh as it is uploaded: its triangles in all orders of plant_mesh_order.hpp, one after the other.
struct OrderedMesh {
  std::vector<PlantVertex> vertices;
  std::vector<std::uint16_t> indices;
  std::size_t index_count = 0;  ///< of one order
  PlantExtent extent;
  [[nodiscard]] std::size_t bytes() const {
    return vertices.size() * sizeof(PlantVertex) + indices.size() * sizeof(std::uint16_t);
  }
};
[[nodiscard]] OrderedMesh ordered(const PlantMesh& mesh);

/// One model of a kind at all its levels of detail; herbs have no close one.
struct ModelMeshes {
  OrderedMesh close;
  OrderedMesh near;
  OrderedMesh mid;
};

/// The models of a web's plants: plant_models of the first of web->levels[0], then those of the next.
struct PlantModels {
  std::shared_ptr<const FoodWeb> web;
  std::vector<ModelMeshes> meshes;
};

/// Makes them on all threads.
[[nodiscard]] std::shared_ptr<const PlantModels> make_plant_models(std::shared_ptr<const FoodWeb> web);

/// Makes models on another thread, so that a window does not wait for them.
class PlantModelMaker {
 public:
  /// Begins with the models of a web, in place of those that were asked for before.
  void start(std::shared_ptr<const FoodWeb> web);
  /// Waits for them until a time; null when they are not there by then.
  [[nodiscard]] std::shared_ptr<const PlantModels> take(std::chrono::steady_clock::time_point until);
  /// Frees what is no longer needed on the other thread.
  void retire(std::shared_ptr<const PlantModels> models) { thread_.retire(std::move(models)); }

 private:
  struct Work {
    std::shared_ptr<const PlantModels> made;
  };
  std::shared_ptr<Work> work_;
  std::future<void> ended_;
  BackgroundThread thread_;
};

}  // namespace biotope
