#pragma once

#include <span>
#include <vector>

#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/cell_runs.hpp"

namespace biotope {

/// Share 0..1 of what it found of a resource in each piece that a level ate; empty when it ate nothing of it. It is the same in
/// all cells of a piece.
[[nodiscard]] std::vector<double> eaten_share(const AnimalLevel& level, int resource);

/// Zones where each of some levels ate the same share of everything: the pieces of their partitions laid over each other.
class EatenZones {
 public:
  /// Zones of the levels that ate any of the resources.
  EatenZones(std::span<const std::shared_ptr<const AnimalLevel>> levels, std::span<const int> resources);

  /// The runs cut at the zones' borders, with value * count() + zone.
  [[nodiscard]] RunTable refined(const RunTable& table) const;
  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] bool nothing_eaten() const { return levels_.empty(); }
  /// Share of a resource (its place in `resources`) that is left in a zone.
  [[nodiscard]] double left(std::int64_t zone, std::size_t resource) const;

 private:
  struct Level {
    const Partition* partition = nullptr;
    std::shared_ptr<const RunTable> pieces;
    /// By resource and piece; empty for what the level did not eat.
    std::vector<std::vector<double>> share;
  };
  std::vector<Level> levels_;
  std::int64_t count_ = 1;
};

}  // namespace biotope
