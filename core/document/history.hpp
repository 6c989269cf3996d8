#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/document/document.hpp"

namespace biotope {

/// A change that can be done, undone and done again.
class Command {
 public:
  virtual ~Command() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  virtual void apply(Document& document) const = 0;
  virtual void revert(Document& document) const = 0;
  /// Memory this command keeps alive.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A stroke over one layer: the tiles it touched, before and after, shared with the document.
class PaintCommand final : public Command {
 public:
  struct TileChange {
    std::size_t tile = 0;
    PaintLayer::TilePointer before;
    PaintLayer::TilePointer after;
  };
  PaintCommand(std::string name, LayerId layer, std::vector<TileChange> changes);
  [[nodiscard]] std::string name() const override;
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  std::string name_;
  LayerId layer_;
  std::vector<TileChange> changes_;
};

/// A change of parameters: the document's non-raster parts before and after (cheap: shared pointers).
class DocumentCommand final : public Command {
 public:
  DocumentCommand(std::string name, Document before, Document after);
  [[nodiscard]] std::string name() const override;
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  std::string name_;
  Document before_;
  Document after_;
};

/// One line of undo and redo with a byte budget; the oldest steps are dropped first.
class History {
 public:
  explicit History(std::size_t byte_budget = std::size_t(512) << 20) : budget_(byte_budget) {}

  /// Applies the command and records it; drops what could be redone.
  void perform(Document& document, std::unique_ptr<Command> command);
  /// Records a command whose effect the document already shows (a stroke painted live).
  void record(std::unique_ptr<Command> command);
  bool undo(Document& document);
  bool redo(Document& document);
  [[nodiscard]] bool can_undo() const { return position_ > 0; }
  [[nodiscard]] bool can_redo() const { return position_ < commands_.size(); }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] std::size_t budget() const { return budget_; }
  /// Names from the oldest to the newest; `position` of them are done.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::size_t position() const { return position_; }
  void clear();

 private:
  void trim();
  std::deque<std::unique_ptr<Command>> commands_;
  std::size_t position_ = 0;
  std::size_t budget_;
};

}  // namespace biotope
