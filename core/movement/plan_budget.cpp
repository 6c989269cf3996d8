#include <algorithm>
#include <map>

#include "core/base/random.hpp"
#include "core/movement/daily_plan.hpp"
#include "core/movement/plan_parts.hpp"

namespace biotope {
namespace {

/// Herds of one species in a level.
struct Group {
  std::size_t level = 0;
  /// Chance and herd.
  std::vector<std::pair<std::uint64_t, int>> herds;
};

/// The largest number such that groups may have that many each, `most` in all.
std::size_t even_share(const std::vector<Group>& groups, std::size_t most) {
  std::size_t low = 0;
  std::size_t high = most;
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    std::size_t sum = 0;
    for (const Group& group : groups) sum += std::min(middle, group.herds.size());
    (sum <= most ? low : high) = sum <= most ? middle : middle - 1;
  }
  return low;
}

}  // namespace

std::vector<std::uint64_t> herd_keys(const AnimalLevel& level, std::uint64_t seed) {
  std::map<std::pair<int, int>, std::uint64_t> count;
  std::vector<std::uint64_t> keys;
  keys.reserve(level.herds.size());
  for (const Herd& herd : level.herds) {
    const std::uint64_t number = count[{herd.species, herd.region}]++;
    keys.push_back(random_bits({seed, std::uint64_t(level.level), std::uint64_t(herd.species), std::uint64_t(herd.region), number}));
  }
  return keys;
}

std::vector<std::vector<int>> planned_herds(std::span<const std::shared_ptr<const AnimalLevel>> levels, std::uint64_t seed, std::size_t most) {
  std::vector<Group> groups;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    std::map<int, Group> by_species;
    const auto keys = herd_keys(*levels[level], seed);
    for (std::size_t herd = 0; herd < keys.size(); ++herd) {
      Group& group = by_species[levels[level]->herds[herd].species];
      group.level = level;
      group.herds.emplace_back(keys[herd], int(herd));
    }
    for (auto& [species, group] : by_species) groups.push_back(std::move(group));
  }
  const std::size_t share = even_share(groups, most);
  std::vector<std::vector<int>> chosen(levels.size());
  for (Group& group : groups) {
    std::sort(group.herds.begin(), group.herds.end());
    group.herds.resize(std::min(group.herds.size(), share));
    for (const auto& [key, herd] : group.herds) chosen[group.level].push_back(herd);
  }
  for (auto& herds : chosen) std::sort(herds.begin(), herds.end());
  return chosen;
}

}  // namespace biotope
