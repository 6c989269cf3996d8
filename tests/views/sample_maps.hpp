#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <string>

#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope::test {

/// A built-in sample, computed once.
inline std::shared_ptr<const MapsSnapshot> sample(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const MapsSnapshot>> computed;
  auto& kept = computed[name];
  if (kept) return kept;
  auto document = open_input("sample:" + name, {}, {});
  REQUIRE(document);
  auto snapshot = solve(*document, nullptr, {});
  REQUIRE(snapshot);
  kept = *snapshot;
  return kept;
}

}  // namespace biotope::test
