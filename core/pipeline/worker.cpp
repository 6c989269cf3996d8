#include "core/pipeline/worker.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

#include "core/base/background_priority.hpp"
#include "core/base/last_owner.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {

// The worker is a state machine with one mailbox slot.
//
//               post                     post: the slot is overwritten, the run goes on
//     idle  ----------->  computing  ------------------------------------------------->  computing-with-newer-input
//       ^                  |      ^    post (another world, or an edit during the tail): also asks the run to stop  |
//       |  run ended,      |      |                                                                                 |
//       +---slot empty-----+      +--------------- run ended or stopped, slot taken --------------------------------+
//
// Whatever arrives during a run costs one further run. A change of terrain, climate or species makes the running one worthless
// and stops it. Any other edit (paint of every kind, things placed) never stops a run that is still at the levels of the food
// chain: they are published again and again while a stroke lasts. The tail of a run, travel, trails and plans, gives way to such
// an edit, so that the levels keep up with the brush; but once edits waited for `patience`, the tail goes on to its end whatever
// arrives. A run that has answered a change of the ground near the brush gives way in the same manner: the next dab is answered
// near it first. Where shares of plants are found anew over the whole land after everything was answered by the schedule of
// before, the run gives way to any edit, however long others waited: shares are of use once the brush rests.
struct Worker::State {
  struct Job {
    Document document;
    std::uint64_t revision = 0;
    bool from_scratch = false;
  };

  mutable std::mutex mutex;
  std::condition_variable_any wake;
  std::condition_variable idle;
  std::optional<Job> slot;
  std::optional<Document> running;
  std::stop_source run_stop;
  std::uint64_t posted = 0;
  std::uint64_t published = 0;
  std::shared_ptr<const MapsSnapshot> latest;
  std::shared_ptr<const MapsSnapshot> complete;
  WorkerProgress progress;
  /// Whether the run gives way to edits: past the levels of the food chain, or past an answer near the brush; whatever waits once
  /// all but the shares of plants is answered.
  bool gives_way = false;
  bool only_refines = false;
  /// Since when edits wait for a complete answer: the first of them, or the last complete answer if that came later.
  std::chrono::steady_clock::time_point waiting_since;
  SolveCache cache;
  /// Snapshots that were published: freed here, not by the window.
  LastOwner old_maps;
  std::jthread thread;

  std::uint64_t post(Document document, bool from_scratch);
  [[nodiscard]] bool lets_edits_pass() const;
  void loop(std::stop_token stop);
  void free_old_maps();
  void run(const Job& job);
  void publish(const MapsSnapshot& maps, std::uint64_t document_revision);
  void publish_failure(const Job& job, const Error& error);
};

namespace {

/// Between looks at maps that nobody shows any more.
constexpr std::chrono::milliseconds free_every{300};
/// After so long a rest memory for the next stroke on the ground is given back. Our choice.
constexpr std::chrono::seconds rest{10};

bool same_world(const Document& a, const Document& b) {
  return a.terrain == b.terrain && a.climate == b.climate && a.species == b.species;
}

/// How long trails and plans wait for a pause between edits. Our choice: with the time they take themselves, they follow a long
/// stroke about every two seconds.
constexpr std::chrono::milliseconds patience{1200};

bool is_tail(std::string_view stage) { return stage == "travel" || stage == "trails" || stage == "daily plans"; }

}  // namespace

/// Whether an edit that waits, or arrives now, stops the run.
bool Worker::State::lets_edits_pass() const {
  return only_refines || (gives_way && std::chrono::steady_clock::now() - waiting_since < patience);
}

std::uint64_t Worker::State::post(Document document, bool from_scratch) {
  const std::lock_guard lock(mutex);
  const bool scratch = from_scratch || (slot && slot->from_scratch);
  if (!running && !slot) waiting_since = std::chrono::steady_clock::now();
  if (running && (from_scratch || lets_edits_pass() || !same_world(*running, document))) run_stop.request_stop();
  slot = Job{std::move(document), ++posted, scratch};
  progress.busy = true;
  wake.notify_one();
  return posted;
}

void Worker::State::free_old_maps() {
  std::vector<std::shared_ptr<const void>> unused;
  const std::lock_guard lock(mutex);
  unused = old_maps.take_unused();
}

void Worker::State::loop(std::stop_token stop) {
  const BackgroundPriority priority;
  auto last_run = std::chrono::steady_clock::now();
  bool resting = true;
  while (true) {
    free_old_maps();
    if (!resting && std::chrono::steady_clock::now() - last_run > rest) {
      cache.release_unused();
      resting = true;
    }
    Job job;
    {
      std::unique_lock lock(mutex);
      if (!slot) {
        running.reset();
        progress = {};
        idle.notify_all();
      }
      const auto posted_to = [&] { return slot.has_value(); };
      if (!wake.wait_for(lock, stop, free_every, posted_to)) {
        if (stop.stop_requested()) return;
        continue;
      }
      job = std::move(*slot);
      slot.reset();
      running = job.document;
      run_stop = std::stop_source();
      if (stop.stop_requested()) return;
    }
    const std::stop_callback forward(stop, [this] {
      const std::lock_guard lock(mutex);
      run_stop.request_stop();
    });
    run(job);
    last_run = std::chrono::steady_clock::now();
    resting = false;
  }
}

void Worker::State::run(const Job& job) {
  if (job.from_scratch) cache = SolveCache();
  TaskContext context;
  {
    const std::lock_guard lock(mutex);
    context.stop = run_stop.get_token();
    progress.busy = true;
    progress.levels_done = 0;
    progress.stale = stale_stages(job.from_scratch ? nullptr : complete.get(), job.document);
    gives_way = only_refines = false;
  }
  context.progress = [this](std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex);
    progress.stage = stage;
    progress.fraction = fraction;
    gives_way = gives_way || is_tail(stage);
    // An edit that arrived while the levels were computed is answered before the tail begins.
    if (slot && lets_edits_pass()) run_stop.request_stop();
  };
  const auto show = [&](std::shared_ptr<const MapsSnapshot> partial) {
    if (context.stopped()) return;
    publish(*partial, job.revision);
    const std::lock_guard lock(mutex);
    gives_way = gives_way || progress.stage == nearby_stage;
    only_refines = partial->complete;
    if (slot && only_refines) run_stop.request_stop();
  };
  Result<std::shared_ptr<const MapsSnapshot>> result = fail(stopped_message);
  try {
    result = solve(job.document, &cache, context, show);
  } catch (const std::bad_alloc&) {
    cache = SolveCache();
    result = fail("Not enough memory for a landscape of this size: crop or resample the terrain.");
  }
  if (result) {
    publish(**result, job.revision);
  } else if (result.error().message != stopped_message) {
    publish_failure(job, result.error());
  }
}

void Worker::State::publish(const MapsSnapshot& maps, std::uint64_t document_revision) {
  auto copy = std::make_shared<MapsSnapshot>(maps);
  const std::lock_guard lock(mutex);
  copy->revision = ++published;
  copy->document_revision = document_revision;
  old_maps.keep(copy);
  latest = copy;
  progress.levels_done = copy->cover.empty() ? 0 : 1 + copy->animals.size();
  // An answer near the brush makes nothing exact.
  if (progress.stage != nearby_stage) progress.stale = still_stale(progress.stale, *copy);
  if (!copy->complete) return;
  complete = copy;
  waiting_since = std::chrono::steady_clock::now();
}

void Worker::State::publish_failure(const Job& job, const Error& error) {
  const std::lock_guard lock(mutex);
  auto copy = complete ? std::make_shared<MapsSnapshot>(*complete) : std::make_shared<MapsSnapshot>();
  if (!complete) copy->document = job.document;
  copy->status = tl::unexpected<Error>(error);
  copy->revision = ++published;
  copy->document_revision = job.revision;
  old_maps.keep(copy);
  latest = copy;
}

Worker::Worker() : state_(std::make_unique<State>()) {
  state_->thread = std::jthread([state = state_.get()](std::stop_token stop) { state->loop(std::move(stop)); });
}

Worker::~Worker() {
  state_->thread.request_stop();
  state_->thread.join();
}

std::uint64_t Worker::post(Document document) { return state_->post(std::move(document), false); }
std::uint64_t Worker::post_from_scratch(Document document) { return state_->post(std::move(document), true); }

void Worker::retire(std::shared_ptr<const void> thing) {
  const std::lock_guard lock(state_->mutex);
  state_->old_maps.keep(std::move(thing));
}

void Worker::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->slot.reset();
  state_->run_stop.request_stop();
  if (!state_->running) state_->progress = {};
}

std::shared_ptr<const MapsSnapshot> Worker::latest() const {
  const std::lock_guard lock(state_->mutex);
  return state_->latest;
}

std::shared_ptr<const MapsSnapshot> Worker::latest_complete() const {
  const std::lock_guard lock(state_->mutex);
  return state_->complete;
}

WorkerProgress Worker::progress() const {
  const std::lock_guard lock(state_->mutex);
  return state_->progress;
}

void Worker::wait_idle() {
  std::unique_lock lock(state_->mutex);
  state_->idle.wait(lock, [&] { return !state_->slot && !state_->running; });
}

}  // namespace biotope
