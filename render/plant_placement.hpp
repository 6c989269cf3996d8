#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/plant_ground.hpp"
#include "render/plant_undergrowth.hpp"

namespace biotope {

/// Side of a block of plants, m. Trees and shrubs, and herbs in finer blocks because one sees them from near only.
inline constexpr float woody_block_side = 64;
inline constexpr float herb_block_side = 16;
/// No tree or shrub is so many times as large as its species' shape says.
inline constexpr float largest_plant_scale = 2.1F;
/// Most kinds of plants that are told apart; later ones look like the last. After them come the kinds of undergrowth.
inline constexpr int most_plant_kinds = 240;
inline constexpr int first_undergrowth_kind = most_plant_kinds;
static_assert(first_undergrowth_kind + undergrowth_kinds <= 256);

/// One plant. Metres from the south-west corner, z above sea level. What the instance buffers hold.
struct PlantInstance {
  float x = 0;
  float y = 0;
  float z = 0;
  float scale = 1;   ///< of the species' mesh; crown area is scale^2 times that of its shape (herbs: height only)
  float turn = 0;    ///< radians about the upright axis
  float tint = 0.5;  ///< 0..1, this plant's shade of colour
  float rank = 0;    ///< 0..1 uniform: a draw that shows a share of the plants shows those of the lowest rank
  float plant = 0;   ///< index in level 0 of the web; from first_undergrowth_kind on a kind of undergrowth
};

/// Where plants stand: a function of place, seed and maps alone, so that neither the order of building nor an edit elsewhere
/// moves a plant.
///
/// Trees are of four ages, shrubs of two, each with its part of the cover and a range of sizes: many small ones, few large ones,
/// and the mean crown area is that of the species' shape. They stand on a hierarchy of cells whose area halves from level to
/// level (32 x 32 m, 16 x 32, 16 x 16, ...). An age of a species belongs to the level whose cells are nearest to its crown's
/// area; a cell holds one plant of its level with the probability that makes the expected crown area equal the cover map's, or
/// else is left to the smaller ones inside of it. So a plant follows from the maps within the largest cell around it that any
/// species uses (`neighbourhood`). A trunk keeps 0.4 crown radii from its cell's border, so that no two trunks stand closer than
/// 0.4 times the sum of their radii. Shrubs do the same under the trees, and are the lower the more of them is eaten.
///
/// Crowding: where the cells of all plants of a stratum would take more than all of the ground (from about 0.7 of cover on),
/// crowns grow larger and plants are fewer by the same factor, at most 1.45, so that their cover stays the map's. `density` is
/// the number that follows.
///
/// Herbs are tufts on a lattice of 0.25 m, whose number is for the eye: as many as there is cover, and the taller and denser the
/// more of their growth is left.
///
/// Nothing stands in water or on a trail as they are drawn: trunks keep their radius from the trail's edge, herbs come one by one
/// as the earth is less worn.
class PlantPlacement {
 public:
  PlantPlacement() = default;
  explicit PlantPlacement(PlantGround ground);
  explicit PlantPlacement(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const ShoreMap> shore = nullptr,
                          std::shared_ptr<const Grazing> grazing = nullptr)
      : PlantPlacement(PlantGround{std::move(snapshot), std::move(shore), nullptr, std::move(grazing)}) {}

  /// Plants of a stratum in block (column, row) counted from the south-west corner, by rising rank.
  [[nodiscard]] std::vector<PlantInstance> block(Stratum stratum, int column, int row) const;
  /// What lies and grows on the ground of block (column, row) of herbs beside its plants, by rising rank: for the eye only. None
  /// where no plant may stand.
  [[nodiscard]] std::vector<PlantInstance> undergrowth(int column, int row) const;
  [[nodiscard]] static float block_side(Stratum stratum) { return stratum == Stratum::herb ? herb_block_side : woody_block_side; }
  [[nodiscard]] const MapsSnapshot* snapshot() const { return snapshot_.get(); }
  [[nodiscard]] PlantGround ground() const { return {snapshot_, shore_, trails_, grazing_}; }
  /// Expected number of trees or shrubs a square metre of a plant (place in level 0 of the web) in a cell, where water and trails
  /// leave room.
  [[nodiscard]] double density(int plant, int x, int y) const;
  /// Sides (m, east and north) of the largest cells that plants of a stratum share: what happens outside of its own does not
  /// change a plant.
  [[nodiscard]] glm::vec2 neighbourhood(Stratum stratum) const;
  /// Whether a plant with a trunk of such a radius (m) may stand at a place, as far as water and trails go.
  [[nodiscard]] bool has_room(float x, float y, float trunk_radius) const;
  /// Radius of a plant's trunk or of its stems together, m.
  [[nodiscard]] float trunk_radius(const PlantInstance& plant) const;

 private:
  struct Kind {
    int plant = 0;
    const CoverMap* cover = nullptr;
    float crown_area = 1;    ///< m2
    float crown_radius = 1;  ///< m
    float height = 1;
    bool evergreen = false;
    float trunk_radius = 0;  ///< m
    /// Ground that the cells of its plants take where it covers all of it.
    float cells_wanted = 1;
  };
  /// Plants of a kind that are of about the same age.
  struct Age {
    std::size_t kind = 0;  ///< place in kinds_ of its stratum
    float least = 1;       ///< scale
    float most = 1;
    float cover = 1;       ///< its share of the kind's cover
    float crown_area = 1;  ///< mean, m2
    int level = 0;
  };
  using Ages = std::vector<const Age*>;
  struct Cell {
    int level = 0;
    int column = 0;
    int row = 0;
  };
  /// A plant that could stand in a cell: where it would, how large, and its share of such cells.
  struct Candidate {
    float x;
    float y;
    float size;
    float share;
  };
  void add_ages(Stratum stratum);
  /// The ages of the kinds that cover any ground in a root cell.
  [[nodiscard]] Ages ages_in(Stratum stratum, int column, int row) const;
  [[nodiscard]] std::optional<Candidate> candidate(Stratum stratum, const Age& age, const Cell& cell, float older,
                                                   const glm::vec2& jitter) const;
  /// `taken`: share of such places that the plants of the larger cells around this one take.
  void woody_cell(Stratum stratum, const Ages& ages, const Cell& cell, float taken, std::vector<PlantInstance>& out) const;
  [[nodiscard]] std::vector<PlantInstance> herbs(int column, int row) const;
  /// What lies or grows in a cell of the undergrowth's lattice.
  [[nodiscard]] std::optional<PlantInstance> undergrowth_at(int lattice_x, int lattice_y) const;
  [[nodiscard]] ForestFloor forest_floor(int x, int y) const;
  /// Share of the ground that the cells of all plants of a stratum would take: above 1, crowns must grow into each other's room.
  [[nodiscard]] float cells_wanted(Stratum stratum, int x, int y) const;
  [[nodiscard]] float crowding(Stratum stratum, int x, int y) const;
  /// Whether a plant may stand at (x, y) metres, in the cell (map_x, map_y), `away` metres or more from drawn water and
  /// `off_trail` metres or more from the edge of a drawn trail.
  [[nodiscard]] bool grows_at(int map_x, int map_y, float x, float y, float away, float off_trail = 0) const;
  /// What browsing leaves of a shrub's size.
  [[nodiscard]] float browsed(Stratum stratum, const PlantInstance& plant) const;
  [[nodiscard]] PlantInstance stand(const Kind& kind, float x, float y) const;

  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::shared_ptr<const ShoreMap> shore_;
  std::shared_ptr<const TrailLines> trails_;
  std::shared_ptr<const Grazing> grazing_;
  std::array<std::vector<Kind>, strata> kinds_;
  std::array<std::vector<Age>, strata> ages_;
};

}  // namespace biotope
