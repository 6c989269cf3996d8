#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/readers.hpp"

/// Called by libFuzzer with one file after another. The reader is chosen when this is compiled.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const biotope_test::FuzzedReader* const reader = [] {
    const auto readers = biotope_test::fuzzed_readers();
    const auto found = std::find_if(readers.begin(), readers.end(), [](const auto& one) { return one.name == BIOTOPE_FUZZED_READER; });
    if (found == readers.end()) std::abort();
    return &*found;
  }();
  reader->read({reinterpret_cast<const char*>(data), size});
  return 0;
}
