#pragma once

#include <future>
#include <thread>

namespace biotope::test {

/// Notes which thread freed it.
struct Noting {
  explicit Noting(std::promise<std::thread::id>& note) : freed_by(note) {}
  ~Noting() { freed_by.set_value(std::this_thread::get_id()); }
  Noting(const Noting&) = delete;
  Noting& operator=(const Noting&) = delete;
  std::promise<std::thread::id>& freed_by;
};

}  // namespace biotope::test
