#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace biotope {

/// Exit codes of the program; scripts depend on them.
enum ExitCode : int {
  exit_success = 0,
  exit_failure = 1,  ///< something could not be read, computed or written
  exit_usage = 2     ///< the command line itself is wrong
};

/// Runs the program: `arguments` without the program's name. What was asked for goes to `out`, progress and messages to `err`.
[[nodiscard]] int run_command_line(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace biotope
