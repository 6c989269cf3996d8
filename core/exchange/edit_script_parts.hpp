#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/status.hpp"
#include "core/climate/climate.hpp"
#include "core/document/document.hpp"
#include "core/document/edit.hpp"
#include "core/species/species.hpp"

namespace biotope {

/// What became of a document's species, by their names.
struct SpeciesPatch {
  /// Species that take the place of the one of their name; those of a new name are put at the end.
  std::vector<Species> changed;
  std::vector<std::string> removed;
  /// All names in their new order; empty: the order follows from the above.
  std::vector<std::string> order;
  bool operator==(const SpeciesPatch&) const = default;
};

/// A PartsEdit as plain data: the parts of a document that are no raster, as they become; what is absent stays as it is.
struct PartsPatch {
  /// What the history shows.
  std::string name;
  std::optional<std::string> title;
  std::optional<std::uint64_t> seed;
  std::optional<Climate> climate;
  std::optional<SpeciesPatch> species;
  std::optional<std::map<int, bool>> use_proportions;
  std::optional<std::vector<Inflow>> inflows;
  std::optional<Placements> placements;
  std::optional<std::map<LayerId, LayerState>> layer_states;

  /// Nothing changes.
  [[nodiscard]] bool empty() const;
};
[[nodiscard]] bool operator==(const PartsPatch& a, const PartsPatch& b);

/// What makes `after` of `before`, rasters apart: `apply(patch_between(a, b), a)` has the parts of b.
[[nodiscard]] PartsPatch patch_between(const Document& before, const Document& after);

/// Changes a document as the patch says. The document stays as it was when the patch does not fit it: a removed species that is
/// not there, an order of other species, species that make no food web, an inflow outside the terrain. The Error begins with
/// `where`.
[[nodiscard]] Status apply(const PartsPatch& patch, Document& document, const std::string& where);

}  // namespace biotope
