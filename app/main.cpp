#include <iostream>
#include <string>
#include <vector>

#include "app/command_line.hpp"

int main(int count, char** values) {
  return biotope::run_command_line({values + 1, values + count}, std::cout, std::cerr);
}
