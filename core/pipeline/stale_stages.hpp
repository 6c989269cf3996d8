#pragma once

#include <limits>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// What has to be computed again before all of a document is answered: what a person sees pulse while it works.
struct StaleStages {
  bool water = false;
  /// Light, temperature, moisture and soil.
  bool environment = false;
  /// Food-chain levels from this one up, plants being 0.
  int levels_from = no_level;
  bool trails = false;
  /// The herds' daily plans.
  bool days = false;

  static constexpr int no_level = std::numeric_limits<int>::max();
  [[nodiscard]] bool level(int number) const { return number >= levels_from; }
  [[nodiscard]] bool any() const { return water || environment || levels_from != no_level || trails || days; }
  bool operator==(const StaleStages&) const = default;
};

/// What a document asks for beyond what `answered` (a complete snapshot; null: nothing) tells, from what was edited: a stage that
/// reads none of the edited inputs, directly or through others, is not stale. A stage named here may still come out as it was.
[[nodiscard]] StaleStages stale_stages(const MapsSnapshot* answered, const Document& document);

/// What is left of `stale` once `reached` (a snapshot of the same document, perhaps partial) is there.
[[nodiscard]] StaleStages still_stale(StaleStages stale, const MapsSnapshot& reached);

}  // namespace biotope
