#include "core/document/history.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <future>
#include <utility>

namespace biotope {

namespace {

/// Steps on either side of where one stands that stay as they are, so that going a few steps back and forth is free; and the
/// memory they may take. Our choice.
constexpr std::size_t steps_kept_loose = 8;
constexpr std::size_t most_bytes_loose = std::size_t(64) << 20;
/// Packed at a time, so that results arrive in portions. Our choice.
constexpr std::size_t most_bytes_a_job = std::size_t(64) << 20;

std::size_t block_bytes(const std::vector<std::pair<const void*, std::size_t>>& blocks) {
  std::size_t sum = 0;
  for (const auto& block : blocks) sum += block.second;
  return sum;
}

}  // namespace

/// Tiles that are being packed by another thread. They are let go on the history's own thread, so that the document never sees
/// them become unshared in the middle of a check.
struct History::Job {
  struct Part {
    std::uint64_t step = 0;
    bool holds_before = true;
    std::vector<std::function<PackedTiles()>> tasks;
    std::vector<PackedTiles> packed;
    void run() {
      for (const auto& task : tasks) packed.push_back(task());
    }
  };
  std::vector<Part> parts;
  std::future<void> finished;
};

History::History(std::size_t byte_budget) : budget_(byte_budget) {}
History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

void History::perform(Document& document, std::unique_ptr<Command> command, std::string_view merge_key) {
  command->apply(document);
  record(std::move(command), merge_key);
}

void History::record(std::unique_ptr<Command> command, std::string_view merge_key) {
  assert(command);
  while (steps_.size() > position_) {
    forget(steps_.back());
    steps_.pop_back();
  }
  if (!merge(*command, merge_key)) {
    Step step;
    step.name = command->name();
    step.number = next_number_++;
    step.command = std::move(command);
    steps_.push_back(std::move(step));
    position_ = steps_.size();
    count(steps_.back());
  }
  merge_key_ = merge_key;
  tidy();
  relieve();
  drop_oldest();
}

bool History::merge(Command& later, std::string_view merge_key) {
  if (merge_key.empty() || steps_.empty() || merge_key_ != merge_key) return false;
  Step& newest = steps_.back();
  if (!newest.command->absorb(later)) return false;
  forget(newest);
  count(newest);
  return true;
}

bool History::undo(Document& document) {
  if (!can_undo()) return false;
  go(document, position_ - 1, &Command::revert, position_ - 1);
  return true;
}

bool History::redo(Document& document) {
  if (!can_redo()) return false;
  go(document, position_, &Command::apply, position_ + 1);
  return true;
}

void History::go(Document& document, std::size_t step, void (Command::*way)(Document&) const, std::size_t position) {
  (steps_[step].command.get()->*way)(document);
  position_ = position;
  end_merging();
  // Its tiles may have been unpacked.
  forget(steps_[step]);
  count(steps_[step]);
  tidy();
  relieve();
}

void History::set_budget(std::size_t byte_budget) {
  budget_ = byte_budget;
  relieve();
  drop_oldest();
}

std::vector<std::string> History::names() const {
  std::vector<std::string> names;
  names.reserve(steps_.size());
  for (const Step& step : steps_) names.push_back(step.name);
  return names;
}

void History::clear() { *this = History(budget_); }

void History::count(Step& step) {
  bool loose = false;
  step.command->visit_tiles([&](PackableTiles& tiles) { loose = loose || tiles.loose(); });
  if (loose) loose_.insert(step.number);
  step.command->visit_blocks([&](const void* block, std::size_t bytes) {
    step.blocks.emplace_back(block, bytes);
    if (holders_[block]++ == 0) bytes_ += bytes;
  });
  step.blocks.shrink_to_fit();
  step.own_bytes =
      sizeof(Step) + step.name.capacity() + step.command->own_bytes() + step.blocks.size() * sizeof(step.blocks.front());
  bytes_ += step.own_bytes;
}

void History::forget(Step& step) {
  for (const auto& [block, bytes] : step.blocks) {
    const auto holders = holders_.find(block);
    if (--holders->second > 0) continue;
    holders_.erase(holders);
    bytes_ -= bytes;
  }
  bytes_ -= std::exchange(step.own_bytes, 0);
  step.blocks = {};
  loose_.erase(step.number);
}

/// Numbers grow along the line. The number of steps when there is no such step.
std::size_t History::index_of(std::uint64_t number) const {
  const auto at = std::lower_bound(steps_.begin(), steps_.end(), number,
                                   [](const Step& step, std::uint64_t wanted) { return step.number < wanted; });
  return at != steps_.end() && at->number == number ? std::size_t(at - steps_.begin()) : steps_.size();
}

std::vector<std::size_t> History::steps_to_pack() const {
  const std::size_t most = std::min(most_bytes_loose, budget_ / 8);
  std::set<std::size_t> kept;
  std::size_t back = 0;
  std::size_t forth = 0;
  // The next step to undo and the next to redo always stay.
  for (std::size_t distance = 0; distance < steps_kept_loose; ++distance) {
    if (distance < position_ && (distance == 0 || back <= most)) {
      kept.insert(position_ - 1 - distance);
      back += block_bytes(steps_[position_ - 1 - distance].blocks);
    }
    if (position_ + distance < steps_.size() && (distance == 0 || forth <= most)) {
      kept.insert(position_ + distance);
      forth += block_bytes(steps_[position_ + distance].blocks);
    }
  }
  std::vector<std::size_t> indices;
  for (const std::uint64_t number : loose_) {
    const std::size_t index = index_of(number);
    if (!kept.contains(index)) indices.push_back(index);
  }
  return indices;
}

void History::start_packing() {
  auto job = std::make_unique<Job>();
  std::size_t bytes = 0;
  for (const std::size_t index : steps_to_pack()) {
    if (bytes > most_bytes_a_job) break;
    bytes += block_bytes(steps_[index].blocks);
    Job::Part part{steps_[index].number, done(index), {}, {}};
    steps_[index].command->visit_tiles([&](PackableTiles& tiles) {
      if (tiles.loose()) part.tasks.push_back(tiles.pack_task(part.holds_before));
    });
    job->parts.push_back(std::move(part));
  }
  if (job->parts.empty()) return;
  job->finished = std::async(std::launch::async, [parts = std::span(job->parts)] {
    for (Job::Part& part : parts) part.run();
  });
  job_ = std::move(job);
}

void History::take_packed() {
  job_->finished.get();
  for (Job::Part& part : job_->parts) {
    const std::size_t index = index_of(part.step);
    if (index == steps_.size() || done(index) != part.holds_before) continue;
    Step& step = steps_[index];
    std::size_t next = 0;
    step.command->visit_tiles([&](PackableTiles& tiles) {
      if (tiles.loose() && next < part.packed.size()) tiles.adopt(std::move(part.packed[next++]));
    });
    forget(step);
    count(step);
  }
  job_.reset();
}

void History::tidy() {
  if (job_ && job_->finished.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  if (job_) take_packed();
  if (!loose_.empty()) start_packing();
}

void History::settle() {
  do {
    if (job_) take_packed();
    start_packing();
  } while (job_);
}

/// Packing makes more room than dropping, but takes time: it is waited for only when much is still to be packed.
void History::relieve() {
  if (bytes_ <= budget_) return;
  std::size_t backlog = 0;
  for (const std::size_t index : steps_to_pack()) backlog += block_bytes(steps_[index].blocks);
  if (backlog > budget_ / 16) settle();
}

/// The newest step always stays, however big: a person must be able to take back what was just done.
void History::drop_oldest() {
  while (bytes_ > budget_ && position_ > 1) {
    forget(steps_.front());
    steps_.pop_front();
    --position_;
    ++dropped_;
  }
}

}  // namespace biotope
