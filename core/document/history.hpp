#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/document/document.hpp"
#include "core/document/tile_changes.hpp"

namespace biotope {

/// A change that can be done, undone and done again. Done and undone in turns, each on the document that the other left.
class Command {
 public:
  virtual ~Command() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  virtual void apply(Document& document) const = 0;
  virtual void revert(Document& document) const = 0;
  /// Memory this command keeps alive.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  /// The part of `bytes` that may be shared with other commands, block by block: History counts each block once.
  virtual void visit_blocks(const BlockVisitor& /*visit*/) const {}
  /// `bytes` without the blocks.
  [[nodiscard]] virtual std::size_t own_bytes() const { return bytes(); }
  /// The tiles that can be packed when the command has become old.
  virtual void visit_tiles(const std::function<void(PackableTiles&)>& /*visit*/) {}
  /// Takes in a later command of the same kind, done after this one, so that both are one. False when it cannot.
  virtual bool absorb(const Command& /*later*/) { return false; }
};

/// A stroke over one layer: the tiles it touched, before and after, shared with the document.
class PaintCommand final : public Command {
 public:
  using TileChange = TileChanges<Paint>::Change;
  PaintCommand(std::string name, LayerId layer, std::vector<TileChange> changes);
  [[nodiscard]] std::string name() const override;
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void visit_blocks(const BlockVisitor& visit) const override;
  [[nodiscard]] std::size_t own_bytes() const override;
  void visit_tiles(const std::function<void(PackableTiles&)>& visit) override;

 private:
  std::string name_;
  LayerId layer_;
  TileChanges<Paint> changes_;
};

/// Several changes as one step, applied in order and reverted backwards.
class GroupCommand final : public Command {
 public:
  GroupCommand(std::string name, std::vector<std::unique_ptr<Command>> commands);
  [[nodiscard]] std::string name() const override;
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void visit_blocks(const BlockVisitor& visit) const override;
  [[nodiscard]] std::size_t own_bytes() const override;
  void visit_tiles(const std::function<void(PackableTiles&)>& visit) override;

 private:
  std::string name_;
  std::vector<std::unique_ptr<Command>> commands_;
};

/// Any change of a document, from the document before and after it. Keeps of layers and masks only the tiles that differ, and of
/// the rest what is cheap: values and shared pointers.
class DocumentCommand final : public Command {
 public:
  DocumentCommand(std::string name, Document before, Document after);
  ~DocumentCommand() override;
  [[nodiscard]] std::string name() const override;
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void visit_blocks(const BlockVisitor& visit) const override;
  [[nodiscard]] std::size_t own_bytes() const override;
  void visit_tiles(const std::function<void(PackableTiles&)>& visit) override;
  /// Takes in another DocumentCommand unless that one changes layers, the selection or the locked area.
  bool absorb(const Command& later) override;

 private:
  class RasterChanges;
  std::string name_;
  /// Without layers, selection and locked area.
  Document before_;
  Document after_;
  std::unique_ptr<RasterChanges> rasters_;
};

/// One line of undo and redo with a byte budget; the oldest steps are dropped first. Steps far from where one stands are packed
/// in the background: see docs/architecture.md.
class History {
 public:
  explicit History(std::size_t byte_budget = std::size_t(1) << 30);
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Applies the command and records it; drops what could be redone. With a `merge_key` that is the newest step's too, both
  /// become one step: a slider that is dragged is one change. Undo, redo, `end_merging` and any other step end that.
  void perform(Document& document, std::unique_ptr<Command> command, std::string_view merge_key = {});
  /// Records a command whose effect the document already shows (a stroke painted live).
  void record(std::unique_ptr<Command> command, std::string_view merge_key = {});
  void end_merging() { merge_key_.clear(); }
  bool undo(Document& document);
  bool redo(Document& document);
  [[nodiscard]] bool can_undo() const { return position_ > 0; }
  [[nodiscard]] bool can_redo() const { return position_ < steps_.size(); }
  /// Memory that all steps keep alive, shared tiles counted once. O(1).
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t budget() const { return budget_; }
  /// Drops the oldest steps when there is not room for all.
  void set_budget(std::size_t byte_budget);
  /// Names from the oldest to the newest; `position` of them are done. O(n); for one name see `name`.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  /// Name of step 0 (the oldest) .. size() - 1. O(1).
  [[nodiscard]] const std::string& name(std::size_t step) const { return steps_[step].name; }
  [[nodiscard]] std::size_t position() const { return position_; }
  /// Steps that had to be dropped since the last `clear`: 'undo' does not reach what was opened when there are any.
  [[nodiscard]] std::size_t dropped() const { return dropped_; }
  void clear();

  /// Picks up what was packed in the background and starts the next. Cheap; called every frame, and by every change.
  void tidy();
  /// Waits until everything is packed that is to be.
  void settle();

 private:
  struct Step {
    std::unique_ptr<Command> command;
    std::string name;
    std::uint64_t number = 0;
    /// As counted in `bytes_`.
    std::size_t own_bytes = 0;
    std::vector<std::pair<const void*, std::size_t>> blocks;
  };
  struct Job;

  void count(Step& step);
  void forget(Step& step);
  bool merge(Command& later, std::string_view merge_key);
  [[nodiscard]] std::size_t index_of(std::uint64_t number) const;
  [[nodiscard]] bool done(std::size_t index) const { return index < position_; }
  [[nodiscard]] std::vector<std::size_t> steps_to_pack() const;
  void start_packing();
  void take_packed();
  void go(Document& document, std::size_t step, void (Command::*way)(Document&) const, std::size_t position);
  void relieve();
  void drop_oldest();

  std::deque<Step> steps_;
  std::size_t position_ = 0;
  std::size_t budget_;
  std::size_t bytes_ = 0;
  std::size_t dropped_ = 0;
  std::uint64_t next_number_ = 1;
  std::string merge_key_;
  /// How many steps hold a block, and the numbers of the steps that hold loose tiles.
  std::unordered_map<const void*, std::uint32_t> holders_;
  std::set<std::uint64_t> loose_;
  std::unique_ptr<Job> job_;
};

}  // namespace biotope
