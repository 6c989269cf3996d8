#pragma once

#include <sys/resource.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>

namespace biotope {

/// How far background threads stand back, on the scale of nice(1): at 10 a waiting window gets about nine tenths of a core it
/// shares.
inline constexpr int background_niceness = 10;

/// Lets the window go first: while it lives, the thread that made it and every thread that joins its parallel loops run at a
/// lower priority. The pool's threads keep it for good (a thread may not raise itself again), so make this only in programs whose
/// parallel loops all run in the background.
class BackgroundPriority final : public tbb::task_scheduler_observer {
 public:
  BackgroundPriority() {
    lower();
    observe(true);
  }
  ~BackgroundPriority() override { observe(false); }
  BackgroundPriority(const BackgroundPriority&) = delete;
  BackgroundPriority& operator=(const BackgroundPriority&) = delete;

  void on_scheduler_entry(bool is_worker) override {
    if (is_worker) lower();
  }

 private:
  /// On Linux 0 is the calling thread, not its process. Where it is refused the thread stays as it is.
  static void lower() {
    thread_local bool lowered = false;
    if (!lowered) (void)setpriority(PRIO_PROCESS, 0, std::min(19, getpriority(PRIO_PROCESS, 0) + background_niceness));
    lowered = true;
  }
};

}  // namespace biotope
