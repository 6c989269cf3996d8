#include "render/plant_selection.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Height on the screen, in pixels of a picture 540 high, from which a plant is a near or a mid mesh.
constexpr float near_pixels = 150;
constexpr float mid_pixels = 62;
constexpr float reference_pixels_per_radian = 579;
/// Within this distance every tuft is drawn, m; beyond it fewer and fewer.
constexpr float dense_tufts = 7;

struct Chosen {
  float distance;
  const PlantInstance* plant;
};

/// Keeps the nearest `most`; the others go to `rest`.
void cut(std::vector<Chosen>& list, std::size_t most, std::vector<Chosen>& rest) {
  if (list.size() <= most) return;
  std::nth_element(list.begin(), list.begin() + std::ptrdiff_t(most), list.end(),
                   [](const Chosen& a, const Chosen& b) { return a.distance < b.distance; });
  rest.insert(rest.end(), list.begin() + std::ptrdiff_t(most), list.end());
  list.resize(most);
}

class Selector {
 public:
  Selector(const std::vector<PlantKind>& kinds, const SpeciesVisibility& visible, const PlantBudget& budget,
           const FrameUniforms& frame, const Frustum& frustum)
      : kinds_(kinds), budget_(budget), eye_(frame.eye), frustum_(frustum) {
    for (const PlantKind& kind : kinds) {
      const auto number = std::size_t(kind.species);
      shown_.push_back(number >= visible.size() || visible[number]);
      largest_radius_ = std::max(largest_radius_, 1.3F * kind.extent.radius);
      tallest_ = std::max(tallest_, 1.3F * kind.extent.height);
    }
  }

  void woody(const PlantBlocks& blocks, Stratum stratum) {
    const float reach = budget_.reach(stratum);
    for (const auto& [place, block] : blocks.blocks(stratum)) {
      if (!meets(place, block, PlantPlacement::block_side(stratum), reach)) continue;
      for (const PlantInstance& plant : block.plants) {
        const auto kind = std::size_t(plant.plant);
        if (kind >= kinds_.size() || !shown_[kind]) continue;
        const glm::vec3 offset = glm::vec3(plant.x, plant.y, plant.z) - eye_;
        const float distance = glm::length(offset);
        const PlantExtent& extent = kinds_[kind].extent;
        const float height = extent.height * plant.scale;
        // Lower plants are lost from sight sooner; toward their reach ever fewer are left.
        const float own_reach = reach * std::min(1.0F, (height + 2) / (stratum == Stratum::tree ? 12.0F : 4.0F));
        if (distance > own_reach * (0.72F + 0.28F * (1 - plant.rank))) continue;
        const float pixels = reference_pixels_per_radian * height / std::max(distance, 0.5F) * (0.88F + 0.24F * plant.rank);
        const Chosen chosen{distance, &plant};
        if (pixels < mid_pixels) {
          far_.push_back(chosen);
          continue;
        }
        const float radius = std::max(0.5F * height, extent.radius * plant.scale) * 1.2F;
        if (!frustum_.meets_sphere(offset + glm::vec3(0, 0, 0.5F * height), radius)) continue;
        (pixels < near_pixels ? mid_ : near_).push_back(chosen);
      }
    }
  }

  void tufts(const PlantBlocks& blocks) {
    for (const auto& [place, block] : blocks.blocks(Stratum::herb)) {
      if (!meets(place, block, herb_block_side, budget_.herb_reach)) continue;
      for (const PlantInstance& plant : block.plants) {
        const auto kind = std::size_t(plant.plant);
        if (kind >= kinds_.size() || !shown_[kind]) continue;
        const glm::vec3 offset = glm::vec3(plant.x, plant.y, plant.z) - eye_;
        const float distance = glm::length(offset);
        const float thin = dense_tufts / std::max(distance, dense_tufts);
        const float edge = 1 - glm::smoothstep(0.75F, 1.0F, distance / budget_.herb_reach);
        if (plant.rank > std::pow(thin, 1.35F) * edge) continue;
        if (!frustum_.meets_sphere(offset, 1)) continue;
        tufts_.push_back({distance, &plant});
      }
    }
  }

  PlantSelection take() {
    PlantSelection out;
    out.near.resize(kinds_.size());
    out.mid.resize(kinds_.size());
    std::vector<Chosen> lost;
    cut(near_, budget_.near, mid_);
    cut(mid_, budget_.mid, far_);
    cut(tufts_, budget_.tufts, lost);
    thin_out(out);
    const auto add = [](const std::vector<Chosen>& list, std::vector<std::vector<PlantInstance>>& to) {
      for (const Chosen& chosen : list) to[std::size_t(chosen.plant->plant)].push_back(*chosen.plant);
    };
    add(near_, out.near);
    add(mid_, out.mid);
    for (const Chosen& tuft : tufts_) {
      PlantInstance plant = *tuft.plant;
      // Fewer but broader tufts from afar.
      plant.scale *= 1 + 0.5F * std::min(1.0F, tuft.distance / 40);
      (tuft.distance < 10 ? out.near : out.mid)[std::size_t(plant.plant)].push_back(plant);
    }
    out.count = near_.size() + mid_.size() + tufts_.size() + out.far.size();
    return out;
  }

 private:
  bool meets(std::pair<int, int> place, const PlantBlock& block, float side, float reach) const {
    if (block.plants.empty()) return false;
    const glm::vec3 low =
        glm::vec3(float(place.second) * side - largest_radius_, float(place.first) * side - largest_radius_, block.low) - eye_;
    const glm::vec3 high = glm::vec3(float(place.second + 1) * side + largest_radius_,
                                     float(place.first + 1) * side + largest_radius_, block.high + tallest_) -
                           eye_;
    const glm::vec3 nearest = glm::max(glm::max(low, -high), glm::vec3(0));
    return glm::length(nearest) <= reach && frustum_.meets_box(low, high);
  }

  /// Puts what is far into the selection; when there is too much, thins it out toward the distance at which the budget is spent.
  void thin_out(PlantSelection& out) {
    out.far_to = budget_.tree_reach;
    if (far_.size() > budget_.far) {
      std::vector<float> distances(far_.size());
      std::transform(far_.begin(), far_.end(), distances.begin(), [](const Chosen& c) { return c.distance; });
      const auto last = distances.begin() + std::ptrdiff_t(budget_.far);
      std::nth_element(distances.begin(), last, distances.end());
      out.far_to = std::min(out.far_to, *last);
    }
    out.far_from = 0.55F * out.far_to;
    out.far.reserve(std::min(far_.size(), budget_.far));
    for (const Chosen& chosen : far_) {
      if (chosen.distance <= out.far_to * (0.72F + 0.28F * (1 - chosen.plant->rank))) out.far.push_back(*chosen.plant);
    }
  }

  const std::vector<PlantKind>& kinds_;
  const PlantBudget& budget_;
  const glm::vec3 eye_;
  const Frustum& frustum_;
  std::vector<bool> shown_;
  float largest_radius_ = 1;
  float tallest_ = 1;
  std::vector<Chosen> near_;
  std::vector<Chosen> mid_;
  std::vector<Chosen> far_;
  std::vector<Chosen> tufts_;
};

}  // namespace

PlantBudget PlantBudget::of(float quality) {
  PlantBudget budget;
  const float q = std::clamp(quality, 0.25F, 4.0F);
  const auto times = [&](std::size_t count) { return std::size_t(float(count) * q); };
  budget.near = times(budget.near);
  budget.mid = times(budget.mid);
  budget.far = times(budget.far);
  budget.tufts = times(budget.tufts);
  const float farther = std::sqrt(q);
  budget.tree_reach *= farther;
  budget.shrub_reach *= farther;
  budget.herb_reach *= farther;
  return budget;
}

PlantSelection select_plants(const PlantBlocks& blocks, const std::vector<PlantKind>& kinds, const SpeciesVisibility& visible,
                             const PlantBudget& budget, const FrameUniforms& frame, const Frustum& frustum) {
  Selector selector(kinds, visible, budget, frame, frustum);
  selector.woody(blocks, Stratum::tree);
  selector.woody(blocks, Stratum::shrub);
  selector.tufts(blocks);
  return selector.take();
}

}  // namespace biotope
