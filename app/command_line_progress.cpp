#include "app/command_line_progress.hpp"

#include <unistd.h>

#include <cmath>
#include <ostream>

namespace biotope {
namespace {

/// A terminal is rewritten at most this often.
constexpr auto refresh = std::chrono::milliseconds(60);

}  // namespace

ProgressLine::ProgressLine(std::ostream& stream, bool terminal, bool quiet)
    : stream_(stream), terminal_(terminal), quiet_(quiet) {}

void ProgressLine::clear() {
  if (terminal_ && !quiet_ && !stage_.empty()) stream_ << "\r\033[K" << std::flush;
  stage_.clear();
}

void ProgressLine::show(std::string_view stage, double fraction) {
  if (quiet_) return;
  const bool new_stage = stage != stage_;
  if (new_stage) stage_ = stage;
  if (!terminal_) {
    if (new_stage && printed_.insert(stage_).second) stream_ << "biotope: " << stage_ << std::endl;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!new_stage && now - shown_ < refresh) return;
  shown_ = now;
  stream_ << "\r\033[K" << stage_;
  if (fraction > 0) stream_ << "  " << std::lround(fraction * 100) << " %";
  stream_ << std::flush;
}

TaskContext ProgressLine::context(std::stop_token stop) {
  return {[this](std::string_view stage, double fraction) { show(stage, fraction); }, std::move(stop)};
}

bool standard_error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace biotope
