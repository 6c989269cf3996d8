#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/path_point.hpp"

namespace biotope {

/// Something that a person should know of a landscape, and where to look.
struct Warning {
  /// What is read: species, what is wrong, by how much, and the place in metres.
  std::string text;
  /// Number in the food web; -1: none in particular.
  int species = -1;
  /// The cell to look at; nothing where it is true of the whole landscape.
  std::optional<PathPoint> place{};
  /// How much is wrong, in `unit`: "kg/yr" of food that is missing, "m2" of ground painted over, "cells"; 0 without an amount.
  double amount = 0;
  std::string unit{};
  bool operator==(const Warning&) const = default;
  friend bool operator==(const Warning& warning, std::string_view text) { return warning.text == text; }
};

}  // namespace biotope
