#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "render/gl_objects.hpp"
#include "render/plant_blocks.hpp"
#include "render/texel_upload.hpp"

namespace biotope {

/// Runs of slots in a row of a bounded number: first fit, neighbours that are free grow together.
class SlotRuns {
 public:
  struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  /// The first slot of a free run of `count`, at most `most` slots in all; nothing when there is none.
  [[nodiscard]] std::optional<std::uint32_t> take(std::uint32_t count, std::uint32_t most);
  void give_back(const Run& run);
  /// One past the last slot that was ever used.
  [[nodiscard]] std::uint32_t end() const { return end_; }
  /// Slots that are taken.
  [[nodiscard]] std::uint32_t taken() const { return taken_; }

 private:
  std::map<std::uint32_t, std::uint32_t> free_;
  std::uint32_t end_ = 0;
  std::uint32_t taken_ = 0;
};

/// Blocks of woody plants on the graphics side, each uploaded once and again when it changes, all in one buffer of bounded size.
class PlantArena {
 public:
  /// A block's plants in the buffer, in the order of their ranks.
  struct Resident {
    SlotRuns::Run run;
    std::uint32_t version = 0;
  };
  using Places = std::map<std::pair<int, int>, Resident>;

  /// Uploads what is new or changed of the blocks of a stratum, nearest to the eye (metres) first and as much as the budget
  /// leaves, and forgets those that are gone, with at most `most` plants of all strata. Where there is not room for all, blocks
  /// far from the eye stay out. Returns false when something is left to upload; what changed is then as it was.
  bool follow(const PlantBlocks& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 eye, UploadBudget& budget);
  [[nodiscard]] const Places& places(Stratum stratum) const { return places_[std::size_t(stratum)]; }
  /// Another number whenever places of a stratum are others.
  [[nodiscard]] std::uint64_t changes(Stratum stratum) const { return changes_[std::size_t(stratum)]; }
  [[nodiscard]] const Buffer& buffer() const { return buffer_; }
  /// Memory of the plants in the buffer, and of the buffer.
  [[nodiscard]] std::size_t bytes() const { return std::size_t(slots_.taken()) * sizeof(PlantInstance); }
  [[nodiscard]] std::size_t most_bytes() const { return std::size_t(room_) * sizeof(PlantInstance); }

 private:
  bool put(const PlantBlock& block, Resident& resident, std::uint32_t most);
  void evict(Places& places, Places::iterator place);
  /// A buffer for so many plants at once: it is not made anew until more are allowed.
  void reserve(std::uint32_t plants);

  /// What was followed to the end: as long as it is the same there is nothing to do.
  struct Followed {
    std::uint64_t blocks = 0;
    std::uint32_t most = 0;
    /// Where there was not room for all: room that was left to others, and where the eye was, in steps.
    bool crowded = false;
    std::uint32_t taken = 0;
    glm::ivec2 eye{0};
    bool operator==(const Followed&) const = default;
  };
  [[nodiscard]] Followed followed(const PlantBlocks& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 eye,
                                  bool crowded) const;
  /// Uploads these, which are nearest first; false when the budget ends before them. `crowded` becomes true where there was not
  /// room for one.
  bool put_all(const PlantBlocks::Map& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 at,
               std::span<const std::pair<int, int>> changed, UploadBudget& budget, bool& crowded);

  SlotRuns slots_;
  Buffer buffer_;
  std::uint32_t room_ = 0;
  std::array<Places, strata> places_;
  std::array<std::uint64_t, strata> changes_{};
  std::array<std::optional<Followed>, strata> followed_;
};

}  // namespace biotope
