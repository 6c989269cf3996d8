#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/line_field.hpp"
#include "render/plant_grazing.hpp"

namespace biotope {

/// Side of a block of plants, m. Trees and shrubs, and herbs in finer blocks because one sees them from near only.
inline constexpr float woody_block_side = 64;
inline constexpr float herb_block_side = 16;
/// Most kinds of plants that are told apart; later ones look like the last.
inline constexpr int most_plant_kinds = 256;
/// No plant grows where more of the ground than this is worn by trails.
inline constexpr float trodden_wear = 0.3F;

/// One plant. Metres from the south-west corner, z above sea level. What the instance buffers hold.
struct PlantInstance {
  float x = 0;
  float y = 0;
  float z = 0;
  float scale = 1;   ///< of the species' mesh; crown area is scale^2 times that of its shape (herbs: height only)
  float turn = 0;    ///< radians about the upright axis
  float tint = 0.5;  ///< 0..1, this plant's shade of colour
  float rank = 0;    ///< 0..1 uniform: a draw that shows a share of the plants shows those of the lowest rank
  float plant = 0;   ///< index in level 0 of the web
};

/// Where plants stand: a function of place, seed and maps alone, so that neither the order of building nor an edit elsewhere
/// moves a plant.
///
/// Trees stand on a hierarchy of cells whose area halves from level to level (32 x 32 m, 16 x 32, 16 x 16, ...). A species
/// belongs to the level whose cells are nearest to its crown's area; a cell holds one plant of its level with the probability
/// that makes the expected crown area equal the cover map's, or else is left to the smaller species inside of it. A trunk keeps
/// 0.4 crown radii from its cell's border, so that no two trunks stand closer than 0.4 times the sum of their radii. Shrubs do
/// the same under the trees. Herbs are tufts on a lattice of 0.25 m, whose number is for the eye: as many as there is cover, and
/// the taller and denser the more of their growth is left.
class PlantPlacement {
 public:
  PlantPlacement() = default;
  /// `shore` is where water is drawn (null: nowhere but in the cells of water); `grazing` what is left of the herbs (null: all).
  explicit PlantPlacement(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const ShoreMap> shore = nullptr,
                          std::shared_ptr<const Grazing> grazing = nullptr);

  /// Plants of a stratum in block (column, row) counted from the south-west corner, by rising rank.
  [[nodiscard]] std::vector<PlantInstance> block(Stratum stratum, int column, int row) const;
  [[nodiscard]] static float block_side(Stratum stratum) { return stratum == Stratum::herb ? herb_block_side : woody_block_side; }
  [[nodiscard]] const MapsSnapshot* snapshot() const { return snapshot_.get(); }

 private:
  struct Kind {
    int plant = 0;
    const CoverMap* cover = nullptr;
    float crown_area = 1;    ///< m2
    float crown_radius = 1;  ///< m
    float height = 1;
    int level = 0;
  };
  struct Cell {
    int level = 0;
    int column = 0;
    int row = 0;
  };
  /// A species that could stand in a cell: where it would, its share of such cells, and how crowded it would stand.
  struct Candidate {
    const Kind* kind;
    float x;
    float y;
    float share;
    float crowding;
  };
  [[nodiscard]] std::vector<Candidate> candidates(Stratum stratum, const Cell& cell, float size, const glm::vec2& jitter) const;
  /// `taken`: share of such places that the plants of the larger cells around this one take.
  void woody_cell(Stratum stratum, const Cell& cell, float taken, std::vector<PlantInstance>& out) const;
  [[nodiscard]] std::vector<PlantInstance> herbs(int column, int row) const;
  /// Share of the ground that the cells of all plants of a stratum would take: above 1, crowns must grow into each other's room.
  [[nodiscard]] float cells_wanted(Stratum stratum, int x, int y) const;
  /// Whether a plant may stand at (x, y) metres, in the cell (map_x, map_y), `away` metres or more from drawn water.
  [[nodiscard]] bool grows_at(int map_x, int map_y, float x, float y, float away) const;
  [[nodiscard]] PlantInstance stand(const Kind& kind, float x, float y) const;

  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::shared_ptr<const ShoreMap> shore_;
  std::shared_ptr<const Grazing> grazing_;
  std::array<std::vector<Kind>, strata> kinds_;
  std::array<int, strata> deepest_{};
};

}  // namespace biotope
