#include "core/species/desired_shares.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

namespace biotope {

namespace {

/// What the level's species have or ask for, sum 1.
std::vector<double> shares_before(const FoodWeb& web, int level, std::string_view climate, std::span<const double> achieved) {
  std::vector<double> shares = desired_proportions(web, level, climate);
  if (!shares.empty()) return shares;
  const std::size_t count = web.levels[std::size_t(level)].size();
  const double sum = std::accumulate(achieved.begin(), achieved.end(), 0.0);
  if (achieved.size() != count || !(sum > 0)) return std::vector<double>(count, 1.0 / double(count));
  for (const double share : achieved) shares.push_back(share / sum);
  return shares;
}

/// The key under which the level's shares of a climate are written.
std::string share_key(const FoodWeb& web, int level, std::string_view climate) {
  const bool has_own = std::ranges::any_of(web.levels[std::size_t(level)], [&](int number) {
    return web.species[std::size_t(number)].proportions.contains(std::string(climate));
  });
  return has_own ? std::string(climate) : "default";
}

}  // namespace

std::vector<Species> with_desired_share(std::vector<Species> all, const FoodWeb& web, int level, std::string_view climate,
                                        std::string_view name, double share, std::span<const double> achieved) {
  const std::vector<int>& numbers = web.levels[std::size_t(level)];
  const auto chosen = std::ranges::find_if(numbers, [&](int number) { return web.species[std::size_t(number)].name == name; });
  assert(chosen != numbers.end());
  const auto position = std::size_t(chosen - numbers.begin());
  std::vector<double> shares = shares_before(web, level, climate, achieved);
  const double others = 1 - shares[position];
  const double rest = 1 - share;
  for (double& each : shares)
    each = others > 1e-9 ? each / others * rest : rest / double(std::max<std::size_t>(shares.size() - 1, 1));
  shares[position] = share;
  const std::string key = share_key(web, level, climate);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string& own = web.species[std::size_t(numbers[i])].name;
    const auto found = std::ranges::find(all, own, &Species::name);
    if (found != all.end()) found->proportions[key] = std::round(shares[i] * 1e4) / 1e4;
  }
  return all;
}

}  // namespace biotope
