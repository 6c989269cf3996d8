#include <catch2/catch.hpp>

#include "ui/widgets.hpp"

using namespace biotope;

namespace {

/// Shows hard spaces, which do not let a line break, as '_'.
std::string shown(std::string_view text) {
  std::string result = unbroken(text);
  for (std::size_t at = result.find("\xc2\xa0"); at != std::string::npos; at = result.find("\xc2\xa0", at)) {
    result.replace(at, 2, "_");
  }
  return result;
}

}  // namespace

TEST_CASE("a line never breaks inside a number, nor between it and its unit") {
  CHECK(shown("Grows 84 816 kg/yr, eaten 20 054 kg/yr") == "Grows 84_816_kg/yr, eaten 20_054_kg/yr");
  CHECK(shown("45 % of 46 %") == "45_% of 46_%");
  CHECK(shown("a herd of 10 needs 3650 kg of bamboo") == "a herd of 10 needs 3650_kg of bamboo");
  CHECK(shown("1.5 m deep, 12 km away") == "1.5_m deep, 12_km away");
}

TEST_CASE("a line breaks before words, also after numbers") {
  CHECK(shown("in 2 regions of 17 herds") == "in 2 regions of 17 herds");
  CHECK(shown("5 places, all 3 more") == "5 places, all 3 more");
  CHECK(shown("") == "");
  CHECK(shown("Stops at 10:30 and") == "Stops at 10:30 and");
  CHECK(shown("no number here") == "no number here");
}
