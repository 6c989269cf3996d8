#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "tests/scenes/small_valley.hpp"

namespace biotope_test {

/// What scripts are played on.
inline biotope::Document valley() {
  auto document = biotope::scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

/// A script of the JSON text of its edits.
inline std::string script_of(const std::string& edits) {
  return R"({"format": "biotope-edits", "version": 1, "edits": [)" + edits + "]}";
}

}  // namespace biotope_test
