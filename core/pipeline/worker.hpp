#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/document/document.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "core/pipeline/stale_stages.hpp"

namespace biotope {

/// What the worker is doing, for the status bar.
struct WorkerProgress {
  bool busy = false;
  std::string stage;
  double fraction = 0;
  /// Food-chain levels, plants first, that answer the document being computed already; those after them are being recomputed.
  std::size_t levels_done = 0;
  /// What the edits since the last complete snapshot ask for and this run has not reached yet.
  StaleStages stale;
};

/// One background thread that keeps a MapsSnapshot up to date with the newest Document posted to it. Any number of posts during a
/// run cost one further run. While edits keep coming the levels of the food chain come first, and trails and plans every now and
/// then: no post starves them. All methods may be called from the UI thread.
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Posts inputs; returns their document revision.
  std::uint64_t post(Document document);
  /// Forgets everything computed, then posts (recompute from scratch).
  std::uint64_t post_from_scratch(Document document);
  /// Has a thing freed in the background as soon as nobody else holds it: a snapshot that was put together of others may be the
  /// last to hold their maps.
  void retire(std::shared_ptr<const void> thing);
  /// Stops the current run; the last good snapshot stays.
  void cancel();
  /// Newest snapshot, partial or complete; null before the first. Never blocks on a computation.
  [[nodiscard]] std::shared_ptr<const MapsSnapshot> latest() const;
  /// Newest complete snapshot; null before the first.
  [[nodiscard]] std::shared_ptr<const MapsSnapshot> latest_complete() const;
  [[nodiscard]] WorkerProgress progress() const;
  /// Blocks until everything posted is computed, cancelled or failed. For tests and the command line.
  void wait_idle();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace biotope
