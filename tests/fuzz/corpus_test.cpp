#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/readers.hpp"

using namespace biotope_test;

// Every file that ever broke a reader, and some that should not, go through the same functions that libFuzzer calls.
TEST_CASE("readers stand every file of the corpus") {
  const std::filesystem::path corpus = std::filesystem::path(BIOTOPE_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  for (const FuzzedReader& reader : fuzzed_readers()) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus / reader.name)) {
      INFO(entry.path().string());
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      const auto started = std::chrono::steady_clock::now();
      reader.read(bytes);
      CHECK(std::chrono::steady_clock::now() - started < std::chrono::seconds(5));
      ++files;
    }
    INFO(reader.name);
    CHECK(files > 0);
  }
}
