#pragma once

#include <cstdint>
#include <initializer_list>

namespace biotope {

/// Counter-based randomness: a value depends only on (seed, what, where, index), never on the order in
/// which values are drawn. The mixer is the finaliser of SplitMix64 (Steele et al. 2014).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

/// Hash of a sequence of counters, for example {seed, what, x, y, index}.
[[nodiscard]] constexpr std::uint64_t random_bits(std::initializer_list<std::uint64_t> counters) {
  std::uint64_t state = 0x6a09e667f3bcc909ULL;
  for (const std::uint64_t counter : counters) state = mix_bits(state ^ mix_bits(counter));
  return state;
}

/// Uniform in [0, 1) with 53 bits.
[[nodiscard]] constexpr double random_unit(std::initializer_list<std::uint64_t> counters) {
  return double(random_bits(counters) >> 11) * 0x1.0p-53;
}

/// Uniform integer in [low, high], both ends included.
[[nodiscard]] constexpr int random_int(int low, int high,
                                       std::initializer_list<std::uint64_t> counters) {
  const auto span = std::uint64_t(std::int64_t(high) - low + 1);
  return low + int(random_bits(counters) % span);
}

}  // namespace biotope
