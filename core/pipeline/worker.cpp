#include "core/pipeline/worker.hpp"

#include <condition_variable>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

#include "core/pipeline/solve.hpp"

namespace biotope {

// The worker is a state machine with one mailbox slot.
//
//               post                     post (paint only): the slot is overwritten, the run goes on to its end
//     idle  ----------->  computing  ----------------------------------------------->  computing-with-newer-input
//       ^                  |      ^    post (another world): also asks the run to stop          |
//       |  run ended,      |      |                                                             |
//       +---slot empty-----+      +--------------- run ended or stopped, slot taken ------------+
//
// Whatever arrives during a run costs one further run. A run under paint is never stopped by more paint, so that a long stroke
// shows complete results again and again; a change of terrain, climate or species makes the running one worthless and stops it.
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
  SolveCache cache;
  std::jthread thread;

  std::uint64_t post(Document document, bool from_scratch);
  void loop(std::stop_token stop);
  void run(const Job& job);
  void publish(const MapsSnapshot& maps, std::uint64_t document_revision);
  void publish_failure(const Job& job, const Error& error);
};

namespace {

bool same_world(const Document& a, const Document& b) {
  return a.terrain == b.terrain && a.climate == b.climate && a.species == b.species;
}

}  // namespace

std::uint64_t Worker::State::post(Document document, bool from_scratch) {
  const std::lock_guard lock(mutex);
  const bool scratch = from_scratch || (slot && slot->from_scratch);
  if (running && (from_scratch || !same_world(*running, document))) run_stop.request_stop();
  slot = Job{std::move(document), ++posted, scratch};
  progress.busy = true;
  wake.notify_one();
  return posted;
}

void Worker::State::loop(std::stop_token stop) {
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex);
      if (!slot) {
        running.reset();
        progress = {};
        idle.notify_all();
      }
      if (!wake.wait(lock, stop, [&] { return slot.has_value(); })) return;
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
  }
}

void Worker::State::run(const Job& job) {
  if (job.from_scratch) cache = SolveCache();
  TaskContext context;
  {
    const std::lock_guard lock(mutex);
    context.stop = run_stop.get_token();
    progress.busy = true;
  }
  context.progress = [this](std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex);
    progress.stage = stage;
    progress.fraction = fraction;
  };
  const auto show = [&](std::shared_ptr<const MapsSnapshot> partial) {
    if (!context.stopped()) publish(*partial, job.revision);
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
  latest = copy;
  if (copy->complete) complete = copy;
}

void Worker::State::publish_failure(const Job& job, const Error& error) {
  const std::lock_guard lock(mutex);
  auto copy = complete ? std::make_shared<MapsSnapshot>(*complete) : std::make_shared<MapsSnapshot>();
  if (!complete) copy->document = job.document;
  copy->status = tl::unexpected<Error>(error);
  copy->revision = ++published;
  copy->document_revision = job.revision;
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
