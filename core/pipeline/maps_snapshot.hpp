#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/status.hpp"
#include "core/climate/environment.hpp"
#include "core/document/document.hpp"
#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_shortage.hpp"
#include "core/movement/daily_plan.hpp"
#include "core/movement/trails.hpp"
#include "core/species/species_library.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"

namespace biotope {

/// Everything that follows from a Document: immutable, made by the pipeline, only read by render, ui and exchange. Parts that did
/// not change are the same pointers as in the snapshot before. Null members are not computed yet.
struct MapsSnapshot {
  /// Counts published snapshots, from 1.
  std::uint64_t revision = 0;
  /// Counts the document's changes this snapshot answers.
  std::uint64_t document_revision = 0;
  /// False while later stages are still to come.
  bool complete = false;
  /// False where plants with desired shares compete by the schedule of before the last edits, and all that lives on them follows
  /// from that: a snapshot with shares found anew over the whole land is to come.
  bool balanced = true;
  /// False where shade that a changed ground throws far away is still that of the ground before, and all that lives there follows
  /// from that.
  bool shaded = true;
  /// Whether nothing of a complete snapshot is as it was before the last edits.
  [[nodiscard]] bool exact() const { return balanced && shaded; }
  /// A failure with the stage's name; the maps are then the last good ones.
  Status status;

  Document document;
  std::shared_ptr<const FoodWeb> web;
  /// The document's terrain with what was painted and drawn on it; the document's own pointer where that is nothing.
  std::shared_ptr<const Terrain> land;
  /// Painted obstacles and passages, and what a person placed for animals.
  std::shared_ptr<const PaintLayer> passage;
  std::shared_ptr<const Places> places;
  std::shared_ptr<const Derivatives> derivatives;
  std::shared_ptr<const Hydrology> hydrology;
  std::shared_ptr<const EnvironmentMaps> environment;
  /// Plants of web->levels[0] as competition made them, and with paint.
  std::vector<std::shared_ptr<const CoverMap>> computed_cover;
  std::vector<std::shared_ptr<const CoverMap>> cover;
  std::vector<double> plant_desired;
  std::vector<double> plant_achieved;
  std::shared_ptr<const Grid<Cover>> tree_cover;
  /// Animal levels 1, 2, ...
  std::vector<std::shared_ptr<const AnimalLevel>> animals;
  std::vector<LevelMovement> movement;
  std::shared_ptr<const ResourceAccessGraph> graph;
  std::shared_ptr<const TrailNetwork> trails;
  std::shared_ptr<const std::vector<DailyPlan>> plans;

  /// Where plants were painted that cannot live there; of complete snapshots.
  std::shared_ptr<const std::vector<PlantShortage>> plant_shortages;
  std::vector<Warning> warnings;
  /// Milliseconds by stage of the run that made this snapshot.
  std::vector<std::pair<std::string, double>> timings;

  /// The ground everything was computed on.
  [[nodiscard]] const std::shared_ptr<const Terrain>& surface() const { return land ? land : document.terrain; }
  [[nodiscard]] const Terrain& terrain() const { return *surface(); }
  /// Paint over a map as it counts, or null.
  [[nodiscard]] std::shared_ptr<const PaintLayer> paint(const LayerId& layer) const { return active_paint(document, layer); }
  /// Growth of a species (number in the web) lost to an external event, or null.
  [[nodiscard]] std::shared_ptr<const PaintLayer> loss(int species) const {
    return web ? paint({LayerKind::loss, web->species[std::size_t(species)].name}) : nullptr;
  }
  /// What plants feel: environment with paint.
  [[nodiscard]] PlantEnvironment plant_environment() const;
  /// Ground as animals meet it.
  [[nodiscard]] Ground ground() const { return {surface(), derivatives, hydrology, tree_cover, passage, places}; }
};

}  // namespace biotope
