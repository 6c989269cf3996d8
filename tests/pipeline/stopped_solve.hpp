#pragma once

#include <stop_token>
#include <string_view>

#include "core/pipeline/solve.hpp"

namespace biotope {

/// Solves with partial answers until it has reported so many times, then stops it; what it finished stays in the cache.
inline void solve_until(const Document& document, SolveCache& cache, int reports) {
  std::stop_source source;
  TaskContext context;
  context.stop = source.get_token();
  context.progress = [&](std::string_view, double) {
    if (--reports <= 0) source.request_stop();
  };
  (void)solve(document, &cache, context, [](const std::shared_ptr<const MapsSnapshot>&) {});
}

}  // namespace biotope
