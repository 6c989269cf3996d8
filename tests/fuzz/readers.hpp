#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace biotope_test {

/// A reader that takes files from strangers. `read` gives it bytes: whatever they are, it must answer with a value or an Error, quickly and
/// without undefined behaviour; and what it takes must survive being written and read again. `read` ends the program when it does not.
struct FuzzedReader {
  /// Also the folder under tests/fuzz/corpus.
  std::string name;
  void (*read)(std::string_view bytes);
};

[[nodiscard]] std::span<const FuzzedReader> fuzzed_readers();

}  // namespace biotope_test
