#include "app/command_line_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <ostream>

namespace biotope {
namespace {

/// A terminal is rewritten at most this often.
constexpr auto refresh = std::chrono::milliseconds(60);

/// The stages a person hears of: the pipeline's, and reading and writing around them. Other names are parts of the stage before.
constexpr std::array<std::string_view, 15> stages{"reading heights", "eroding",     "playing edits", "species",      "slopes",
                                                  "water",           "environment", "plants",        "animals",      "travel",
                                                  "trails",          "daily plans", "saving",        "writing maps", "drawing"};

bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

ProgressLine::ProgressLine(std::ostream& stream, bool terminal, bool quiet)
    : stream_(stream), terminal_(terminal), quiet_(quiet) {}

void ProgressLine::clear() {
  if (terminal_ && !quiet_ && shown_ != std::chrono::steady_clock::time_point{}) stream_ << "\r\033[K" << std::flush;
  stage_.clear();
  shown_ = {};
}

void ProgressLine::show(std::string_view name, double fraction) {
  if (quiet_) return;
  const auto stage = std::ranges::find_if(stages, [&](std::string_view known) { return same_word(known, name); });
  if (stage != stages.end() && *stage != stage_) {
    stage_ = *stage;
    shown_ = {};
    if (!terminal_ && printed_.insert(stage_).second) stream_ << "biotope: " << stage_ << std::endl;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - shown_ < refresh) return;
  shown_ = now;
  stream_ << "\r\033[K" << stage_;
  if (stage == stages.end()) stream_ << (stage_.empty() ? "" : ": ") << name;
  if (fraction > 0) stream_ << "  " << std::lround(fraction * 100) << " %";
  stream_ << std::flush;
}

TaskContext ProgressLine::context(std::stop_token stop) {
  return {[this](std::string_view stage, double fraction) { show(stage, fraction); }, std::move(stop)};
}

bool standard_error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace biotope
