#include <fcntl.h>
#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace {

/// Opens what a script has closed of standard input, output and error, so that no file of ours gets their numbers and text meant
/// for a terminal ends up in a map.
void open_standard_streams() {
  int descriptor = ::open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDWR);
  if (descriptor >= 0) ::close(descriptor);
}

}  // namespace

int main(int count, char** values) {
  open_standard_streams();
  const int code = biotope::run_command_line({values + 1, values + count}, std::cout, std::cerr);
  if (std::cout.flush() || code != biotope::exit_success) return code;
  std::cerr << "biotope: standard output cannot be written." << std::endl;
  return biotope::exit_failure;
}
