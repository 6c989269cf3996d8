#include "render/animal_proportions.hpp"

#include <array>
#include <utility>

namespace biotope {

namespace {

constexpr std::array<std::pair<std::string_view, AnimalProportions>, 11> builds{{
    {"bovid", {1.25F, 0.56F, 0.38F, 0.16F, 0.062F, 0.22F, -8, 0.17F, 0.33F, 0.12F, 0.08F, 0.35F, 0.022F, -80}},
    {"deer", {1.02F, 0.38F, 0.25F, 0.02F, 0.036F, 0.46F, 52, 0.085F, 0.30F, 0.07F, 0.13F, 0.12F, 0.03F, -55}},
    {"horse", {1.10F, 0.42F, 0.28F, 0.03F, 0.042F, 0.50F, 42, 0.11F, 0.38F, 0.085F, 0.10F, 0.48F, 0.05F, -75}},
    {"goat", {1.00F, 0.42F, 0.29F, 0.02F, 0.046F, 0.34F, 45, 0.10F, 0.27F, 0.075F, 0.10F, 0.12F, 0.03F, 20}},
    {"sheep", {1.05F, 0.46F, 0.34F, 0.02F, 0.045F, 0.30F, 38, 0.12F, 0.28F, 0.08F, 0.09F, 0.10F, 0.03F, -60}},
    {"bear", {1.35F, 0.58F, 0.46F, 0.08F, 0.095F, 0.26F, 4, 0.20F, 0.36F, 0.14F, 0.09F, 0.06F, 0.04F, -40}},
    {"wolf", {1.12F, 0.36F, 0.23F, 0.02F, 0.045F, 0.30F, 24, 0.11F, 0.33F, 0.075F, 0.13F, 0.48F, 0.06F, -50}},
    {"cat", {1.15F, 0.36F, 0.25F, 0.0F, 0.055F, 0.22F, 26, 0.11F, 0.27F, 0.095F, 0.13F, 0.18F, 0.05F, -45}},
    {"fox", {1.25F, 0.34F, 0.23F, 0.0F, 0.042F, 0.28F, 22, 0.11F, 0.34F, 0.08F, 0.18F, 0.85F, 0.095F, -25}},
    {"boar", {1.20F, 0.56F, 0.36F, 0.08F, 0.05F, 0.16F, -4, 0.18F, 0.42F, 0.11F, 0.12F, 0.18F, 0.02F, -70}},
    {"rhino", {1.35F, 0.62F, 0.46F, 0.10F, 0.095F, 0.24F, -12, 0.20F, 0.44F, 0.14F, 0.10F, 0.28F, 0.03F, -80}},
}};

}  // namespace

AnimalProportions animal_proportions(std::string_view model) {
  for (const auto& [name, build] : builds) {
    if (name == model) return build;
  }
  return builds[1].second;
}

}  // namespace biotope
