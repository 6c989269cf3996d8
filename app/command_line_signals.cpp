#include "app/command_line_signals.hpp"

#include <unistd.h>

namespace biotope {
namespace {

constexpr int interrupted_exit_code = 130;

void watch(std::stop_token ending, sigset_t signals, std::stop_source source) {
  const timespec pause{0, 50'000'000};
  while (!ending.stop_requested()) {
    if (::sigtimedwait(&signals, nullptr, &pause) < 0) continue;
    if (source.stop_requested()) ::_exit(interrupted_exit_code);
    source.request_stop();
  }
}

}  // namespace

StopOnSignal::StopOnSignal() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  // Blocked here and so in every thread made from now on: only the watcher receives them.
  ::pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  watcher_ = std::jthread(watch, signals_, source_);
}

StopOnSignal::~StopOnSignal() {
  watcher_.request_stop();
  watcher_.join();
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace biotope
