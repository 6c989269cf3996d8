#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

PlantEnvironment MapsSnapshot::plant_environment() const {
  return {environment,
          {paint({LayerKind::resource, "illumination"}), paint({LayerKind::resource, "temperature"}),
           paint({LayerKind::resource, "moisture"})},
          {paint({LayerKind::resource, "texture"}), paint({LayerKind::geology, "class"})}};
}

}  // namespace biotope
