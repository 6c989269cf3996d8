#pragma once

#include <cstdint>
#include <vector>

namespace biotope {

/// Sizes of the herds that `individuals` form: as many as suit the mean size, each within [smallest, largest], and their sum is
/// `individuals`. Where no such split exists (fewer than one herd, or a number between two) the sizes come as near to the range
/// as they can. `place` tells apart herds of one seed, for instance by species and region.
[[nodiscard]] std::vector<int> herd_sizes(int individuals, int smallest, int largest, std::uint64_t seed, std::uint64_t place);

}  // namespace biotope
