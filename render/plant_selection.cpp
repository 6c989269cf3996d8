#include "render/plant_selection.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

constexpr float reference_pixels_per_radian = 579;
/// Levels of detail overlap while a plant is between this share of a height and all of it; the same as in plant_lod.glsl.
constexpr float overlap = 0.95F;
/// A plant fades out over this share of the ranks.
constexpr float rank_fade = 0.05F;
/// Far plants begin to thin out at this share of the distance where none is left.
constexpr float thinning = 0.3F;
/// Within this distance every tuft is drawn, m; beyond it fewer and fewer.
constexpr float dense_tufts = 6;

/// A plant that may be a mesh, its height on the screen and its distance.
struct Candidate {
  float pixels;
  const PlantInstance* plant;
  float distance;
};

/// Height on the screen of a plant; those of a high rank count as a little taller. The same as in plant_lod.glsl.
float seen_pixels(const glm::vec3& offset, float height, float rank) {
  return reference_pixels_per_radian * height / std::max(glm::length(offset), 0.5F) * (0.88F + 0.24F * rank);
}

/// The height from which at most `most` are taller, if that is more than `least`.
float height_of_last(std::vector<Candidate>& list, std::size_t most, float least) {
  if (list.size() <= most) return least;
  const auto last = list.begin() + std::ptrdiff_t(most);
  std::nth_element(list.begin(), last, list.end(), [](const Candidate& a, const Candidate& b) { return a.pixels > b.pixels; });
  return std::max(least, last->pixels / overlap);
}

/// What is drawn first hides what is behind it, of which then only the depth is looked at.
void nearest_first(std::vector<Candidate>& list) {
  std::sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
}

/// Share of far plants that are left at a distance.
float far_share(const PlantLevels& levels, float distance) {
  return 1 - glm::smoothstep(levels.far_from, levels.far_to, distance);
}

/// A block in sight, by its distance.
struct SeenBlock {
  float distance;
  const WoodyBlock* block;
};

class Selector {
 public:
  Selector(const PlantKinds& plants, const SpeciesVisibility& visible, const PlantBudget& budget, const FrameUniforms& frame,
           const Frustum& frustum)
      : kinds_(plants.kinds()), floor_(plants.undergrowth()), budget_(budget), eye_(frame.eye), frustum_(frustum) {
    for (const PlantKind& kind : kinds_) {
      const auto number = std::size_t(kind.species);
      shown_.push_back(number >= visible.size() || visible[number]);
      auto& tallest = tallest_[std::size_t(kind.stratum)];
      tallest = std::max(tallest, 1.2F * largest_plant_scale * kind.extent.height);
      largest_radius_ = std::max(largest_radius_, largest_plant_scale * kind.extent.radius);
    }
    out_.tuft_change = {0.7F * budget.blade_reach, budget.blade_reach};
    out_.herb_reach = budget.herb_reach;
    out_.eye = eye_;
    for (auto* lists : {&out_.close, &out_.near, &out_.mid}) lists->resize(plant_models * kinds_.size());
    out_.near_tufts.resize(kinds_.size());
    out_.far_tufts.resize(kinds_.size());
    out_.undergrowth.resize(floor_.size());
  }

  void woody(const PlantBlocks& blocks, const WoodyBlocks& woody) {
    std::array<std::vector<SeenBlock>, 2> seen;
    for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
      auto& list = seen[std::size_t(stratum)];
      for (const WoodyBlock& block : woody.of(stratum)) {
        const float distance = distance_of({block.row, block.column}, block.low, block.high, stratum);
        if (distance > budget_.reach(stratum)) continue;
        list.push_back({distance, &block});
        if (reference_pixels_per_radian * tallest_[std::size_t(stratum)] * 1.12F >= overlap * budget_.mid_pixels * distance) {
          gather(*block.block);
        }
      }
    }
    meshes();
    for (auto& list : seen) {
      std::stable_sort(list.begin(), list.end(), [](const SeenBlock& a, const SeenBlock& b) { return a.distance < b.distance; });
    }
    // Trees first: what they leave of the budget is the shrubs'.
    std::size_t left = budget_.far;
    for (const std::size_t s : {std::size_t(Stratum::tree), std::size_t(Stratum::shrub)}) {
      // Where blocks are still to be built, the ground shows their trees.
      const float reach = std::min(budget_.reach(Stratum(s)), blocks.whole_to(Stratum(s)));
      left -= std::min(left, far(seen[s], s, s == 0 ? left * 4 / 5 : left, reach));
    }
  }

  void tufts(const PlantBlocks& blocks) {
    std::vector<std::pair<float, const PlantInstance*>> tufts;
    for (const auto& [place, block] : blocks.blocks(Stratum::herb)) {
      const float nearest = distance_of(place, block.low, block.high, Stratum::herb);
      if (nearest > budget_.herb_reach) continue;
      for (const PlantInstance& plant : block.plants) {
        // They come by rank: none of the others can be meant.
        if (plant.rank > tuft_share(nearest)) break;
        const auto kind = std::size_t(plant.plant);
        if (kind >= kinds_.size() || !shown_[kind]) continue;
        const glm::vec3 offset = glm::vec3(plant.x, plant.y, plant.z) - eye_;
        const float distance = glm::length(offset);
        if (plant.rank > tuft_share(distance) || !frustum_.meets_sphere(offset, 1)) continue;
        tufts.emplace_back(distance, &plant);
      }
    }
    if (tufts.size() > budget_.tufts) {
      // Those of the highest rank at their distance are left out, everywhere alike.
      const auto need = [&](const auto& tuft) { return tuft.second->rank / tuft_share(tuft.first); };
      const auto last = tufts.begin() + std::ptrdiff_t(budget_.tufts);
      std::nth_element(tufts.begin(), last, tufts.end(), [&](const auto& a, const auto& b) { return need(a) < need(b); });
      tufts.erase(last, tufts.end());
    }
    std::sort(tufts.begin(), tufts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, plant] : tufts) {
      const auto kind = std::size_t(plant->plant);
      if (distance < out_.tuft_change.y) out_.near_tufts[kind].push_back(*plant);
      if (distance > out_.tuft_change.x) out_.far_tufts[kind].push_back(*plant);
    }
    out_.count += tufts.size();
  }

  /// What lies on the ground, as far as it is large enough on the screen.
  void undergrowth(const PlantBlocks& blocks) {
    std::vector<Candidate> found;
    for (const auto& [place, block] : blocks.blocks(Stratum::herb)) {
      if (block.undergrowth.empty()) continue;
      if (distance_of(place, block.low, block.high, Stratum::herb) > budget_.herb_reach) continue;
      for (const PlantInstance& plant : block.undergrowth) {
        const PlantExtent& extent = floor_[std::size_t(plant.plant) - first_undergrowth_kind].extent;
        const glm::vec3 offset = glm::vec3(plant.x, plant.y, plant.z) - eye_;
        const float pixels = seen_pixels(offset, extent.height * plant.scale, plant.rank);
        if (pixels < overlap * budget_.undergrowth_pixels || !frustum_.meets_sphere(offset, extent.radius * plant.scale + 1))
          continue;
        found.push_back({pixels, &plant, glm::length(offset)});
      }
    }
    out_.undergrowth_pixels = height_of_last(found, budget_.undergrowth, budget_.undergrowth_pixels);
    nearest_first(found);
    for (const Candidate& one : found) {
      if (one.pixels <= overlap * out_.undergrowth_pixels) continue;
      out_.undergrowth[std::size_t(one.plant->plant) - first_undergrowth_kind].push_back(*one.plant);
    }
  }

  PlantSelection take() { return std::move(out_); }

 private:
  /// Distance from the eye of the nearest point of a block whose feet are between two heights; infinite when nothing of it is in
  /// sight.
  float distance_of(std::pair<int, int> place, float lowest, float highest, Stratum stratum) const {
    constexpr float out_of_sight = 1e9F;
    if (lowest > highest) return out_of_sight;
    const float side = PlantPlacement::block_side(stratum);
    const float margin = stratum == Stratum::herb ? 0.5F : largest_radius_;
    const glm::vec3 low = glm::vec3(float(place.second) * side - margin, float(place.first) * side - margin, lowest) - eye_;
    const glm::vec3 high = glm::vec3(float(place.second + 1) * side + margin, float(place.first + 1) * side + margin,
                                     highest + tallest_[std::size_t(stratum)]) -
                           eye_;
    if (!frustum_.meets_box(low, high)) return out_of_sight;
    return glm::length(glm::max(glm::max(low, -high), glm::vec3(0)));
  }

  float tuft_share(float distance) const {
    const float thin = dense_tufts / std::max(distance, dense_tufts);
    return std::pow(thin, 1.25F) * (1 - glm::smoothstep(0.7F, 1.0F, distance / budget_.herb_reach));
  }

  /// Plants of a block that are tall enough on the screen to be meshes.
  void gather(const PlantBlock& block) {
    for (const PlantInstance& plant : block.plants) {
      const auto kind = std::size_t(plant.plant);
      if (kind >= kinds_.size() || !shown_[kind]) continue;
      const glm::vec3 offset = glm::vec3(plant.x, plant.y, plant.z) - eye_;
      const PlantExtent& extent = kinds_[kind].extent;
      const float height = extent.height * plant.scale;
      const float pixels = seen_pixels(offset, height, plant.rank);
      if (pixels < overlap * budget_.mid_pixels) continue;
      const float radius = std::max(0.5F * height, extent.radius * plant.scale) * 1.25F;
      if (!frustum_.meets_sphere(offset + glm::vec3(0, 0, 0.5F * height), radius)) continue;
      candidates_.push_back({pixels, &plant, glm::length(offset + glm::vec3(0, 0, 0.5F * height))});
    }
  }

  void meshes() {
    const float mid = height_of_last(candidates_, budget_.near + budget_.mid, budget_.mid_pixels);
    const float near = std::max(mid, height_of_last(candidates_, budget_.near, budget_.near_pixels));
    const float close = std::max(near, height_of_last(candidates_, budget_.close, budget_.close_pixels));
    for (PlantLevels& levels : out_.levels) levels = {close, near, mid, 0, 0};
    nearest_first(candidates_);
    for (const Candidate& candidate : candidates_) {
      if (candidate.pixels <= overlap * mid) continue;
      const PlantInstance& plant = *candidate.plant;
      const std::size_t list = plant_models * std::size_t(plant.plant) + std::size_t(model_of(plant));
      // Between two levels it is drawn in both, each with a part of its leaves.
      if (candidate.pixels > overlap * close) out_.close[list].push_back(plant);
      if (candidate.pixels > overlap * near && candidate.pixels < close) out_.near[list].push_back(plant);
      if (candidate.pixels < near) out_.mid[list].push_back(plant);
      ++out_.count;
    }
  }

  /// Plants of a block that some share of them shows.
  static std::size_t plants_at(const PlantBlock& block, float share) {
    const float rank = share * (1 + rank_fade);
    if (share >= 1 || block.plants.empty() || block.plants.back().rank <= rank) return block.plants.size();
    const auto end = std::upper_bound(block.plants.begin(), block.plants.end(), rank,
                                      [](float value, const PlantInstance& plant) { return value < plant.rank; });
    return std::size_t(end - block.plants.begin());
  }

  static std::size_t plants_within(const std::vector<SeenBlock>& seen, const PlantLevels& levels) {
    std::size_t sum = 0;
    for (const SeenBlock& block : seen) {
      const float share = far_share(levels, block.distance);
      if (share > 0) sum += std::size_t(float(block.block->plants) * std::min(1.0F, share * (1 + rank_fade)));
    }
    return sum;
  }

  /// Far plants of a stratum, out to where the budget is spent. Returns their number.
  std::size_t far(const std::vector<SeenBlock>& seen, std::size_t stratum, std::size_t most, float reach) {
    PlantLevels& levels = out_.levels[stratum];
    // Where there was no room for a block, none is drawn beyond it either.
    for (const SeenBlock& block : seen) {
      if (!block.block->resident) reach = std::min(reach, std::max(block.distance, 50.0F));
    }
    const auto set = [&](float to) {
      levels.far_from = thinning * to;
      levels.far_to = std::max(to, 1.0F);
    };
    set(reach);
    if (plants_within(seen, levels) > most) {
      float low = 0;
      float high = reach;
      for (int step = 0; step < 14; ++step) {
        set(0.5F * (low + high));
        (plants_within(seen, levels) > most ? high : low) = 0.5F * (low + high);
      }
      set(std::max(low, 1.0F));
    }
    std::size_t sum = 0;
    for (const SeenBlock& block : seen) {
      const float share = far_share(levels, block.distance);
      if (!block.block->resident || share <= 0) continue;
      // A block that waits for its upload shows what it was.
      const SlotRuns::Run& run = block.block->there.run;
      const std::size_t plants = std::min(plants_at(*block.block->block, share), std::size_t(run.count));
      if (plants == 0) continue;
      out_.far[stratum].push_back({4, std::uint32_t(plants), 0, run.first});
      sum += plants;
    }
    out_.count += sum;
    return sum;
  }

  const std::vector<PlantKind>& kinds_;
  const std::vector<PlantKind>& floor_;
  const PlantBudget& budget_;
  const glm::vec3 eye_;
  const Frustum& frustum_;
  std::vector<bool> shown_;
  float largest_radius_ = 1;
  std::array<float, strata> tallest_{1, 1, 1};
  std::vector<Candidate> candidates_;
  PlantSelection out_;
};

}  // namespace

PlantBudget PlantBudget::of(float quality) {
  PlantBudget budget;
  const float q = std::clamp(quality, 0.25F, 4.0F);
  const auto times = [](std::size_t count, float factor) { return std::size_t(float(count) * factor); };
  // Below medium the meshes are what costs most: fewer of them than of the rest.
  const float meshes = q <= 1 ? std::pow(q, 2.5F) : q;
  budget.near = times(budget.near, q <= 1 ? std::pow(q, 1.8F) : q);
  budget.mid = times(budget.mid, meshes);
  budget.close = times(budget.close, std::pow(q, 1.5F));
  budget.undergrowth = times(budget.undergrowth, q <= 1 ? q * q : std::pow(q, 1.6F));
  // A GPU draws far plants by the million; a processor counts each.
  const float far = q <= 1 ? q : std::pow(q, 2.9F);
  budget.far = times(budget.far, far);
  budget.resident = std::uint32_t(times(budget.resident, q <= 1 ? q : std::pow(q, 1.3F) * std::sqrt(std::max(1.0F, 0.5F * q))));
  budget.tufts = times(budget.tufts, q <= 1 ? q : std::pow(q, 1.6F));
  const float farther = q <= 1 ? std::sqrt(q) : q;
  budget.tree_reach *= farther;
  // A strong graphics card has room for shrubs from hill to hill.
  budget.shrub_reach *= farther * std::pow(std::max(1.0F, 0.5F * q), 0.6F);
  budget.herb_reach *= std::sqrt(q);
  budget.blade_reach *= q <= 1 ? std::sqrt(q) : q;
  if (q > 1) {
    budget.close_pixels /= std::sqrt(q);
    budget.undergrowth_pixels /= std::sqrt(q);
    budget.near_pixels /= std::sqrt(q);
    budget.mid_pixels /= std::sqrt(q);
  }
  return budget;
}

PlantSelection select_plants(const PlantBlocks& blocks, const WoodyBlocks& woody, const PlantKinds& plants,
                             const SpeciesVisibility& visible, const PlantBudget& budget, const FrameUniforms& frame,
                             const Frustum& frustum) {
  Selector selector(plants, visible, budget, frame, frustum);
  selector.woody(blocks, woody);
  selector.tufts(blocks);
  selector.undergrowth(blocks);
  return selector.take();
}

}  // namespace biotope
