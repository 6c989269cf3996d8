#include "render/plant_branches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace biotope {

namespace {

constexpr float golden_turn = 2.39996F;  // 137.5 degrees
/// Twigs end at this share of the crown's radius: the rest is leaves.
constexpr float twigs_reach = 0.82F;

/// The crown as a space that branches stay in.
class CrownSpace {
 public:
  CrownSpace(const PlantShape& shape, const CrownOutline& outline)
      : outline_(outline),
        radius_(twigs_reach * 0.5F * shape.crown_diameter),
        foot_(shape.height * shape.trunk_fraction),
        top_(shape.height) {}

  bool holds(const glm::vec3& at) const {
    const float height = (at.z - foot_) / (top_ - foot_);
    if (height > 1) return false;
    // Below its foot a crown may hang down a little.
    if (height < -0.08F) return std::hypot(at.x, at.y) < 0.2F * radius_;
    return std::hypot(at.x, at.y) < radius_ * std::max(0.1F, outline_.radius(std::max(height, 0.06F)));
  }

  /// How far one can go before one leaves the crown.
  float reach(const glm::vec3& from, const glm::vec3& along) const {
    const float step = 0.05F * (top_ - foot_);
    float length = step;
    while (length < 2 * top_ && holds(from + along * (length + step))) length += step;
    return length;
  }

 private:
  CrownOutline outline_;
  float radius_;
  float foot_;
  float top_;
};

/// A branch while it grows: what hangs on it comes later.
struct Growing {
  Branch branch;
  int parent = -1;
  int parent_point = 0;
  float load = 0;  ///< tips that it carries at its end
  int limb = 0;
};

class Grower {
 public:
  Grower(const PlantShape& shape, const BranchingHabit& habit, MeshRandom& random)
      : shape_(shape), habit_(habit), random_(random), space_(shape, habit.outline) {}

  Branching grow() {
    for (int stem = 0; stem < habit_.stems; ++stem) trunk(stem);
    const std::size_t trunks = growing_.size();
    for (int limb = 0; limb < habit_.limbs; ++limb) add_limb(limb, limb % int(trunks));
    const std::size_t limbs = growing_.size();
    for (std::size_t i = trunks; i < limbs; ++i) side_branches(int(i), habit_.shoots, 2);
    const std::size_t shoots = growing_.size();
    for (std::size_t i = limbs; i < shoots; ++i) side_branches(int(i), habit_.twigs, 3);
    thicken();
    return finish();
  }

 private:
  glm::vec3 aside(const glm::vec3& along, float turn, float angle) const {
    const glm::vec3 right = perpendicular(along);
    const glm::vec3 forward = glm::cross(along, right);
    return glm::normalize(along * std::cos(angle) + (right * std::cos(turn) + forward * std::sin(turn)) * std::sin(angle));
  }

  void trunk(int stem) {
    Growing growing;
    const float turn = golden_turn * float(stem) + random_.between(0, 0.8F);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const bool many = habit_.stems > 1;
    glm::vec3 at = many ? out * 0.012F * shape_.height : glm::vec3(0);
    at.z = -0.02F * shape_.height;
    glm::vec3 along = glm::normalize(glm::vec3(0, 0, 1) + out * (many ? habit_.lean * random_.between(0.7F, 1.25F) : 0.0F));
    constexpr int pieces = 6;
    const float end = habit_.leader * shape_.height * (many ? random_.between(0.82F, 1.0F) : 1.0F);
    for (int i = 0; i <= pieces; ++i) {
      growing.branch.points.push_back(at);
      at += along * (end / pieces);
      along = glm::normalize(along + random_.direction() * habit_.wander + glm::vec3(0, 0, many ? 0.1F : 0.05F));
    }
    growing_.push_back(std::move(growing));
  }

  void add_limb(int number, int trunk_number) {
    const Branch& trunk = growing_[std::size_t(trunk_number)].branch;
    // Denser toward the top, where limbs are shorter.
    const float share = (float(number) + 0.5F) / float(habit_.limbs);
    const float height = shape_.height * glm::mix(habit_.first, habit_.leader, std::pow(share, 0.85F));
    std::size_t point = 1;
    while (point + 1 < trunk.points.size() && trunk.points[point].z < height) ++point;
    const glm::vec3 start = trunk.points[point];
    const glm::vec3 before = trunk.points[point - 1];
    const float part = glm::clamp((height - before.z) / std::max(start.z - before.z, 0.01F), 0.0F, 1.0F);
    const glm::vec3 from = glm::mix(before, start, part);
    const float angle = glm::mix(habit_.low_angle, habit_.high_angle, share) * random_.between(0.85F, 1.15F);
    const float turn = golden_turn * float(number) + random_.between(-0.3F, 0.3F);
    const glm::vec3 along(std::cos(turn) * std::sin(angle), std::sin(turn) * std::sin(angle), std::cos(angle));
    branch_off(trunk_number, int(part > 0.5F ? point : point - 1), from, along,
               space_.reach(from, along) * random_.between(0.8F, 0.98F), habit_.rise, 3, 1, number);
  }

  /// Side branches of branch `of`, the first at a third of it.
  void side_branches(int of, int count, int order) {
    const int limb = growing_[std::size_t(of)].limb;
    for (int i = 0; i < count; ++i) {
      const std::vector<glm::vec3> points = growing_[std::size_t(of)].branch.points;
      const float length = glm::length(points.back() - points.front());
      const float share = 0.32F + 0.6F * (float(i) + random_.unit() * 0.8F) / float(count);
      const float place = share * float(points.size() - 1);
      const auto point = std::size_t(place);
      const glm::vec3 from = glm::mix(points[point], points[point + 1], place - float(point));
      const glm::vec3 direction = glm::normalize(points[point + 1] - points[point]);
      const glm::vec3 along = aside(direction, golden_turn * float(i + 3 * limb) + random_.between(-0.4F, 0.4F),
                                    habit_.shoot_angle * random_.between(0.75F, 1.25F));
      const float wanted = length * habit_.shoot_length * (1.25F - 0.55F * share) * random_.between(0.8F, 1.2F);
      branch_off(of, int(point), from, along, std::min(wanted, 1.05F * space_.reach(from, along)), habit_.shoot_rise, 2, order,
                 limb);
    }
  }

  void branch_off(int parent, int parent_point, const glm::vec3& from, glm::vec3 along, float length, float rise, int pieces,
                  int order, int limb) {
    Growing growing;
    growing.parent = parent;
    growing.parent_point = parent_point;
    growing.limb = limb;
    growing.branch.order = order;
    if (order == 3) pieces = 1;
    glm::vec3 at = from;
    growing.branch.points.push_back(at);
    for (int i = 0; i < pieces; ++i) {
      at += along * (length / float(pieces));
      growing.branch.points.push_back(at);
      along = glm::normalize(along + glm::vec3(0, 0, rise / float(pieces)) + random_.direction() * 1.5F * habit_.wander);
    }
    growing.load = 1;
    growing_.push_back(std::move(growing));
  }

  /// Pipe model: cross sections add up from the tips down.
  void thicken() {
    std::vector<std::vector<float>> loads;
    for (const Growing& growing : growing_) loads.emplace_back(growing.branch.points.size(), growing.load);
    // Children come after their parents.
    for (std::size_t i = growing_.size(); i-- > 0;) {
      const Growing& growing = growing_[i];
      if (growing.parent < 0) continue;
      auto& carried = loads[std::size_t(growing.parent)];
      for (int point = 0; point <= growing.parent_point; ++point) carried[std::size_t(point)] += loads[i].front();
    }
    const float foot = habit_.trunk_radius * shape_.height;
    const float whole = std::max(1.0F, loads.front().front());
    for (std::size_t i = 0; i < growing_.size(); ++i) {
      for (std::size_t point = 0; point < loads[i].size(); ++point) {
        const bool tip = point + 1 == loads[i].size();
        const float load = tip ? 0.2F : std::max(loads[i][point], 0.6F);
        growing_[i].branch.radii.push_back(std::min(1.2F * foot, foot * std::pow(load / whole, 0.5F)));
      }
      // The foot of a trunk spreads into its roots.
      if (growing_[i].parent < 0) growing_[i].branch.radii.front() *= 1.45F;
    }
  }

  Branching finish() {
    Branching out;
    out.stems = habit_.stems;
    std::vector<glm::vec3> low(std::size_t(habit_.limbs), glm::vec3(1e9F));
    std::vector<glm::vec3> high(std::size_t(habit_.limbs), glm::vec3(-1e9F));
    for (Growing& growing : growing_) {
      if (growing.parent >= 0) {
        const auto& points = growing.branch.points;
        const auto limb = std::size_t(growing.limb);
        const glm::vec3 last = points.back() - points[points.size() - 2];
        out.spots.push_back({points.back(), glm::normalize(last), growing.limb, glm::length(last)});
        low[limb] = glm::min(low[limb], points.back());
        high[limb] = glm::max(high[limb], points.back());
      }
      out.branches.push_back(std::move(growing.branch));
    }
    const float least = 0.16F * shape_.crown_diameter;
    for (std::size_t limb = 0; limb < low.size(); ++limb) {
      out.bunches.push_back({0.5F * (low[limb] + high[limb]), glm::max(0.6F * (high[limb] - low[limb]), glm::vec3(least))});
    }
    return out;
  }

  const PlantShape& shape_;
  const BranchingHabit& habit_;
  MeshRandom& random_;
  CrownSpace space_;
  std::vector<Growing> growing_;
};

}  // namespace

float CrownOutline::radius(float height) const {
  if (height < widest) {
    const float below = (widest - height) / std::max(widest, 0.01F);
    return glm::mix(std::sqrt(std::max(0.0F, 1 - below * below)), 1.0F - 0.25F * below, flat);
  }
  const float above = std::min(1.0F, (height - widest) / (1 - widest));
  return glm::mix(std::sqrt(1 - above * above), 1 - above, pointed);
}

Branching grow_branches(const PlantShape& shape, const BranchingHabit& habit, MeshRandom& random) {
  return Grower(shape, habit, random).grow();
}

void add_branches(PlantMeshBuilder& builder, const Branching& branching, PlantDetail detail) {
  for (const Branch& branch : branching.branches) {
    const auto& points = branch.points;
    if (detail == PlantDetail::close && branch.order == 0) {
      builder.trunk(points, branch.radii, branching.stems > 2 ? 8 : 13, branching.stems > 2 ? 3 : 5);
    } else if (detail == PlantDetail::close && branch.order < 3) {
      builder.stem(points, branch.radii, branch.order == 1 ? 6 : 4);
    } else if (detail == PlantDetail::near && branch.order < 2) {
      builder.stem(points, branch.radii, branch.order > 0 ? 3 : branching.stems > 2 ? 4 : 6);
    } else if (detail != PlantDetail::mid) {
      builder.strip(points, branch.radii, glm::normalize(builder.random.direction() + glm::vec3(0, 0, 0.3F)));
    } else if (branch.order == 0) {
      const std::array<glm::vec3, 3> few{points.front(), points[points.size() / 2], points.back()};
      const std::array<float, 3> thick{branch.radii.front(), branch.radii[points.size() / 2], branch.radii.back()};
      builder.stem(few, thick, 3);
    } else if (branch.order == 1) {
      const std::array<glm::vec3, 2> few{points.front(), points.back()};
      const std::array<float, 2> thick{branch.radii.front(), branch.radii.back()};
      builder.strip(few, thick, glm::normalize(builder.random.direction() + glm::vec3(0, 0, 0.3F)));
    }
  }
}

}  // namespace biotope
