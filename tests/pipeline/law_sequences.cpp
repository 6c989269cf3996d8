#include <tbb/global_control.h>
#include <catch2/catch.hpp>

#include <cstdlib>
#include <optional>
#include <thread>

#include "core/pipeline/solve.hpp"
#include "core/pipeline/worker.hpp"
#include "tests/pipeline/edit_steps.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/pipeline/stopped_solve.hpp"

using namespace biotope;

namespace {

/// How many sequences to try; BIOTOPE_LAW_SEQUENCES asks for more than the tests usually do.
int sequences(int usual) {
  const char* asked = std::getenv("BIOTOPE_LAW_SEQUENCES");
  return asked != nullptr ? std::atoi(asked) : usual;
}

const Document& tiny() {
  static const Document document = [] {
    auto made = tiny_document();
    if (!made) FAIL(made.error().message);
    return *made;
  }();
  return document;
}

std::shared_ptr<const MapsSnapshot> from_scratch(const Document& document, std::size_t threads) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const auto maps = solve(document);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

/// A law: given the steps of a session, what breaks it; empty when it holds.
using Law = std::function<std::string(const std::vector<Step>&)>;

/// The incremental answer at the end of a session is that from scratch, on one thread.
std::string incremental_is_scratch(const std::vector<Step>& steps) {
  Session session(tiny());
  SolveCache cache;
  (void)solve(session.document(), &cache);
  for (const Step& step : steps) {
    session.perform(step);
    if (step.answer == Answer::whole)
      (void)solve(session.document(), &cache, {}, [](const std::shared_ptr<const MapsSnapshot>&) {});
    if (step.answer == Answer::stopped) solve_until(session.document(), cache, 1 + int(step.number % 29));
  }
  const auto maps = solve(session.document(), &cache);
  if (!maps) return maps.error().message;
  return first_difference(**maps, *from_scratch(session.document(), 1));
}

/// The answer of a worker that gets every step while it computes is that from scratch. What is in progress when depends on time;
/// the law does not.
std::string worker_is_scratch(const std::vector<Step>& steps) {
  Session session(tiny());
  Worker worker;
  worker.post(session.document());
  for (const Step& step : steps) {
    session.perform(step);
    if (step.answer == Answer::stopped) worker.cancel();
    worker.post(session.document());
    if (step.answer == Answer::whole) std::this_thread::sleep_for(std::chrono::microseconds(step.number % 8000));
  }
  worker.wait_idle();
  const auto maps = worker.latest_complete();
  if (!maps) return "no complete answer";
  if (!worker.latest()->status) return worker.latest()->status.error().message;
  return first_difference(*maps, *from_scratch(session.document(), 2));
}

/// Leaves out steps as long as the law is still broken: halves first, then ever smaller parts.
std::vector<Step> shrunk(std::vector<Step> steps, const Law& law) {
  for (std::size_t part = std::max<std::size_t>(1, steps.size() / 2);;) {
    bool smaller = false;
    for (std::size_t first = 0; first < steps.size();) {
      std::vector<Step> fewer = steps;
      fewer.erase(fewer.begin() + std::ptrdiff_t(first), fewer.begin() + std::ptrdiff_t(std::min(first + part, fewer.size())));
      if (law(fewer).empty()) {
        first += part;
      } else {
        steps = std::move(fewer);
        smaller = true;
      }
    }
    if (part == 1 && !smaller) return steps;
    if (part > 1) part /= 2;
  }
}

/// Tries a law over random sessions; a broken one is shrunk and told.
void hold(const Law& law, int count, std::uint64_t stream) {
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = random_bits({stream, std::uint64_t(i)});
    const auto steps = random_steps(seed, random_int(2, 9, {seed}));
    const std::string broken = law(steps);
    if (broken.empty()) continue;
    const auto smallest = shrunk(steps, law);
    std::string text = "sequence " + std::to_string(i) + ", seed " + std::to_string(seed) + ": " + law(smallest) + " after";
    for (const Step& step : smallest) text += "\n  " + to_string(step);
    FAIL(text);
  }
}

}  // namespace

TEST_CASE("Incremental equals from scratch over hundreds of random sessions with stops in the middle, whatever the threads") {
  hold(incremental_is_scratch, sequences(200), 1);
}

TEST_CASE("A worker that gets edits while it computes ends with the answer from scratch") {
  hold(worker_is_scratch, sequences(60), 2);
}

TEST_CASE("A broken law shrinks to the steps that break it") {
  const Law twice_hidden = [](const std::vector<Step>& steps) {
    const auto hides = std::count_if(steps.begin(), steps.end(), [](const Step& step) { return step.kind == StepKind::hide; });
    return std::string(hides >= 2 ? "broken" : "");
  };
  std::vector<Step> steps = random_steps(5, 40);
  steps[3].kind = StepKind::hide;
  steps[31].kind = StepKind::hide;
  const auto smallest = shrunk(steps, twice_hidden);
  CHECK(smallest.size() == 2);
  CHECK(std::all_of(smallest.begin(), smallest.end(), [](const Step& step) { return step.kind == StepKind::hide; }));
}
