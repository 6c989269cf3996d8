#include "core/ecosystem/herds.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"

namespace biotope {
namespace {

constexpr std::uint64_t herd_size_stream = 0x68657264;

}  // namespace

std::vector<int> herd_sizes(int individuals, int smallest, int largest, std::uint64_t seed, std::uint64_t place) {
  if (individuals <= 0) return {};
  smallest = std::max(1, smallest);
  largest = std::max(smallest, largest);
  const int fewest = (individuals + largest - 1) / largest;
  const int most = std::max(1, individuals / smallest);
  const int usual = int(std::lround(2.0 * individuals / (smallest + largest)));
  const int count = std::clamp(usual, std::min(fewest, most), most);

  std::vector<int> sizes(static_cast<std::size_t>(count));
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = random_int(smallest, largest, {seed, herd_size_stream, place, i});
    sum += sizes[i];
  }
  // The last herds take up the difference as far as the range allows, the very last whatever remains.
  for (std::size_t i = sizes.size(); i-- > 0;) {
    const auto adjusted = std::clamp<std::int64_t>(sizes[i] + individuals - sum, smallest, largest);
    sum += adjusted - sizes[i];
    sizes[i] = int(adjusted);
  }
  sizes.back() += int(individuals - sum);
  return sizes;
}

}  // namespace biotope
