#include "core/pipeline/worker.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/pipeline/solve.hpp"
#include "tests/pipeline/random_edits.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

Document start() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

}  // namespace

TEST_CASE("The worker ends with the complete answer to the newest document, however many were posted") {
  Worker worker;
  Document document = start();
  worker.post(document);
  worker.wait_idle();
  REQUIRE(worker.latest_complete());
  std::uint64_t last = 0;
  for (std::uint64_t number = 100; number < 110; ++number) {
    random_edit(document, *worker.latest_complete(), number);
    last = worker.post(document);
  }
  worker.wait_idle();
  const auto maps = worker.latest_complete();
  CHECK(maps->document_revision == last);
  CHECK(worker.latest() == maps);
  CHECK_FALSE(worker.progress().busy);
  const auto scratch = solve(document);
  REQUIRE(scratch);
  require_same(*maps, **scratch);
}

TEST_CASE("A change of climate during a run replaces it") {
  Worker worker;
  Document document = start();
  worker.post(document);
  document.climate.precipitation[5] += 20;
  const auto revision = worker.post(document);
  worker.wait_idle();
  REQUIRE(worker.latest_complete());
  CHECK(worker.latest_complete()->document_revision == revision);
  CHECK(worker.latest_complete()->document.climate == document.climate);
}

TEST_CASE("Cancelling keeps the last good maps, and the worker can be used again") {
  Worker worker;
  Document document = start();
  worker.post(document);
  worker.wait_idle();
  const auto good = worker.latest_complete();
  document.climate.lapse_rate = 5;
  const auto revision = worker.post(document);
  worker.cancel();
  worker.wait_idle();
  const auto kept = worker.latest_complete();
  CHECK((kept == good || kept->document_revision == revision));
  worker.post_from_scratch(document);
  worker.wait_idle();
  CHECK(worker.latest_complete()->document.climate.lapse_rate == 5);
}

TEST_CASE("A failure is a status on the last good maps") {
  Worker worker;
  Document document = start();
  worker.post(document);
  worker.wait_idle();
  document.species = std::make_shared<const std::vector<Species>>();
  worker.post(document);
  worker.wait_idle();
  REQUIRE(worker.latest());
  CHECK_FALSE(worker.latest()->status);
  CHECK(worker.latest()->cover.size() == worker.latest_complete()->cover.size());
}

TEST_CASE("What is retired is kept while anybody holds it, and then freed") {
  Worker worker;
  auto held = std::make_shared<const MapsSnapshot>();
  const std::weak_ptr<const MapsSnapshot> seen = held;
  worker.retire(held);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK_FALSE(seen.expired());
  held.reset();
  for (int i = 0; i < 1000 && !seen.expired(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(seen.expired());
}

TEST_CASE("A worker may be destroyed in the middle of a run") {
  Worker worker;
  worker.post(start());
}
