#include <algorithm>

#include "core/document/edit_commands.hpp"

namespace biotope {
namespace {

bool same_inflows(const std::vector<Inflow>& a, const std::vector<Inflow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Inflow& one, const Inflow& other) {
    return one.x == other.x && one.y == other.y && one.catchment_area == other.catchment_area;
  });
}

bool same_species(const std::shared_ptr<const std::vector<Species>>& a, const std::shared_ptr<const std::vector<Species>>& b) {
  return a == b || (a && b && *a == *b);
}

bool same_selection(const std::shared_ptr<const SelectionMask>& a, const std::shared_ptr<const SelectionMask>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

bool same_document(const Document& a, const Document& b) {
  return a.terrain == b.terrain && same_inflows(a.inflows, b.inflows) && a.climate == b.climate &&
         same_species(a.species, b.species) && a.use_proportions == b.use_proportions && a.seed == b.seed &&
         a.layers == b.layers && a.layer_states == b.layer_states && same_selection(a.selection, b.selection) &&
         same_selection(a.locked_area, b.locked_area) && a.placements == b.placements &&
         a.given_environment.monthly == b.given_environment.monthly &&
         a.given_environment.geology == b.given_environment.geology && a.title == b.title;
}

CommandResult parts_command(const Document& document, const PartsEdit& edit) {
  if (!edit.change) return fail("The edit '" + edit.name + "' holds no change.");
  Document after = document;
  edit.change(after);
  if (same_document(document, after)) return std::unique_ptr<Command>{};
  return std::make_unique<DocumentCommand>(edit.name, document, std::move(after));
}

}  // namespace biotope
