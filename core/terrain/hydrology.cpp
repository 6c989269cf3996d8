#include "core/terrain/hydrology.hpp"

#include "core/terrain/hydrology_state.hpp"

namespace biotope {

Result<Hydrology> compute_hydrology(const Terrain& terrain, const HydrologyOptions& options, const TaskContext& context) {
  return HydrologyState().compute(terrain, options, context);
}

}  // namespace biotope
