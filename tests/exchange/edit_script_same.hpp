#pragma once

#include <catch2/catch.hpp>

#include "core/exchange/edit_script.hpp"

namespace biotope_test {

inline void require_same(const biotope::Brush& a, const biotope::Brush& b) {
  REQUIRE(a.mode == b.mode);
  REQUIRE(a.radius == b.radius);
  REQUIRE(a.strength == b.strength);
  REQUIRE(a.hardness == b.hardness);
  REQUIRE(a.value == b.value);
  REQUIRE(a.floor == b.floor);
  REQUIRE(a.falloff == b.falloff);
  REQUIRE(a.spacing == b.spacing);
  REQUIRE(a.pressure_sizes == b.pressure_sizes);
  REQUIRE(a.pressure_strengthens == b.pressure_strengthens);
  REQUIRE(a.noise_size == b.noise_size);
  REQUIRE(a.noise_seed == b.noise_seed);
  REQUIRE(a.stamp_turn == b.stamp_turn);
  REQUIRE(a.stamp_turns_by_chance == b.stamp_turns_by_chance);
  REQUIRE(a.clone_offset == b.clone_offset);
  REQUIRE(a.filter == b.filter);
}

template <class Entry>
void require_same_painting(const Entry& a, const Entry& b) {
  REQUIRE(a.stamp == b.stamp);
  REQUIRE(a.edit.targets == b.edit.targets);
  REQUIRE(a.edit.clone_from == b.edit.clone_from);
  require_same(a.edit.brush, b.edit.brush);
}

inline void require_same(const std::vector<biotope::ScriptEntry>& a, const std::vector<biotope::ScriptEntry>& b);

struct RequireSame {
  const biotope::ScriptEntry& other;
  void operator()(const biotope::StrokeEntry& entry) const {
    const auto& to = std::get<biotope::StrokeEntry>(other.what);
    require_same_painting(entry, to);
    REQUIRE(entry.edit.points == to.edit.points);
  }
  void operator()(const biotope::FillEntry& entry) const {
    const auto& to = std::get<biotope::FillEntry>(other.what);
    require_same_painting(entry, to);
    REQUIRE(entry.edit.gradient == to.edit.gradient);
  }
  void operator()(const biotope::GroupEntry& entry) const {
    const auto& to = std::get<biotope::GroupEntry>(other.what);
    REQUIRE(entry.name == to.name);
    require_same(entry.entries, to.entries);
  }
  void operator()(const biotope::OpenEntry& entry) const {
    const auto& to = std::get<biotope::OpenEntry>(other.what);
    REQUIRE(entry.sample == to.sample);
    REQUIRE(entry.file == to.file);
  }
  template <class Plain>
  void operator()(const Plain& entry) const {
    REQUIRE(entry == std::get<Plain>(other.what));
  }
};

/// Every entry is the same, every number to the bit.
inline void require_same(const std::vector<biotope::ScriptEntry>& a, const std::vector<biotope::ScriptEntry>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    INFO("entry " << i + 1 << ", " << biotope::entry_kind(a[i]));
    REQUIRE(a[i].what.index() == b[i].what.index());
    std::visit(RequireSame{b[i]}, a[i].what);
  }
}

}  // namespace biotope_test
