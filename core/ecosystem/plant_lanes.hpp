#pragma once

#include <array>
#include <cstdint>
#include <cstring>

// Eight floats side by side, for the inner loops of plants. Lanes never mix, so results do not depend on how many there are
// nor on the processor: the same operations are done in the same order whatever the width of its vectors.

// Vectors are passed between functions that are always inlined: the calling convention that GCC warns about is never used.
#pragma GCC diagnostic ignored "-Wpsabi"

/// A function that takes or returns Lanes; inlined so that it is compiled for the vectors of its caller.
#define BIOTOPE_INLINE inline __attribute__((always_inline))

namespace biotope {

/// 8 floats fill a register of AVX2.
inline constexpr int lane_count = 8;
using Lanes = float __attribute__((vector_size(sizeof(float) * lane_count)));

/// Lanes as a member of containers, which need its alignment.
struct alignas(sizeof(Lanes)) LaneValues {
  Lanes v{};
};

BIOTOPE_INLINE Lanes lanes(float value) { return Lanes{} + value; }
BIOTOPE_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
BIOTOPE_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return a > b ? a : b; }
/// Clamped to 0..1.
BIOTOPE_INLINE Lanes share(const Lanes& x) { return smaller(larger(x, Lanes{}), lanes(1)); }

/// Whether a lane is positive; none may be negative.
BIOTOPE_INLINE bool any(const Lanes& values) {
  std::array<std::uint64_t, sizeof(values) / sizeof(std::uint64_t)> words;
  std::memcpy(words.data(), &values, sizeof(values));
  std::uint64_t found = 0;
  for (const std::uint64_t word : words) found |= word;
  return found != 0;
}

}  // namespace biotope
