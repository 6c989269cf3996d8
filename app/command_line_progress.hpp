#pragma once

#include <chrono>
#include <iosfwd>
#include <set>
#include <string>
#include <string_view>

#include "core/base/task_context.hpp"

namespace biotope {

/// Shows what a computation is doing: one line that is rewritten on a terminal, a line a stage elsewhere, nothing when quiet.
class ProgressLine {
 public:
  ProgressLine(std::ostream& stream, bool terminal, bool quiet);
  /// Clears the line, so that what follows starts at its beginning.
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `name` is a stage, or a part of the one shown last.
  void show(std::string_view name, double fraction);
  void clear();
  /// A context whose progress this line shows.
  [[nodiscard]] TaskContext context(std::stop_token stop = {});

 private:
  std::ostream& stream_;
  bool terminal_;
  bool quiet_;
  std::string stage_;
  std::set<std::string> printed_;
  std::chrono::steady_clock::time_point shown_{};
};

/// True when standard error is a terminal.
[[nodiscard]] bool standard_error_is_terminal();

}  // namespace biotope
