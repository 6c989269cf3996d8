#pragma once

#include <bit>
#include <cstdint>

namespace biotope {

/// An integer that orders like the float; both zeros are one.
[[nodiscard]] inline std::uint32_t ordered_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

}  // namespace biotope
