#pragma once

#include <functional>
#include <memory>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Called with partial snapshots while a solve runs (complete == false), and with a complete one that is not exact yet; may be
/// empty.
using PublishPartial = std::function<void(std::shared_ptr<const MapsSnapshot>)>;

/// What a solve leaves behind for the next one: the output of every operator beside the inputs it was made from. An operator
/// whose inputs are the same is not run again; one that is local to tiles runs only over the tiles that differ. Holds results,
/// never decisions: with an empty cache the answer is the same to the bit.
class SolveCache {
 public:
  SolveCache();
  ~SolveCache();
  SolveCache(SolveCache&&) noexcept;
  SolveCache& operator=(SolveCache&&) noexcept;

  struct Stages;
  [[nodiscard]] Stages& stages() { return *stages_; }

  /// Gives back memory that only waits for the next change of the ground. Results stay.
  void release_unused();

 private:
  std::unique_ptr<Stages> stages_;
};

/// Computes everything that follows from the document, from scratch when `cache` is null. Fails with the stage's name, or with
/// "Stopped." when the context asks; what was finished by then stays in the cache. Deterministic for any thread count.
[[nodiscard]] Result<std::shared_ptr<const MapsSnapshot>> solve(const Document& document, SolveCache* cache = nullptr,
                                                                const TaskContext& context = {},
                                                                const PublishPartial& publish = {});

/// Stage that answers a change of the ground around it; what follows makes the answer exact.
inline constexpr const char* nearby_stage = "nearby";

/// Message of a solve that was stopped by its context.
inline constexpr const char* stopped_message = "Stopped.";

}  // namespace biotope
