#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include "core/document/edit.hpp"
#include "ui/background_task.hpp"

namespace biotope {

/// Edits that are asked for and not done yet.
struct PendingEdits {
  /// The first is being made.
  std::deque<Edit> waiting;
  BackgroundTask<std::unique_ptr<Command>> making;
  /// Count of edits of the document it is made of.
  std::uint64_t edits_before = 0;
};

}  // namespace biotope
