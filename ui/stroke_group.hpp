#pragma once

#include <list>
#include <memory>
#include <vector>

#include "ui/paint_session.hpp"

namespace biotope {

/// Several steps of the history that are done and taken back as one.
class GroupCommand final : public Command {
 public:
  GroupCommand(std::string name, std::vector<std::unique_ptr<Command>> parts);
  [[nodiscard]] std::string name() const override { return name_; }
  void apply(Document& document) const override;
  void revert(Document& document) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  std::string name_;
  std::vector<std::unique_ptr<Command>> parts_;
};

/// Strokes of one brush movement over the layers that are painted beside the one that is looked at.
class StrokeGroup {
 public:
  /// Starts a stroke over a layer's computed map.
  void begin(const PaintGround& ground);
  /// Moves the brush over every layer. True when something may have changed.
  bool move_to(Document& document, const Brush& brush, float x, float y);
  /// The undo steps of the strokes that changed something.
  [[nodiscard]] std::vector<std::unique_ptr<Command>> finish(const Document& document);
  [[nodiscard]] bool empty() const { return strokes_.empty(); }
  void close() { strokes_.clear(); }

 private:
  struct Member {
    std::shared_ptr<const Grid<float>> computed;  // outlives the stroke over it
    Stroke stroke;
  };
  std::list<Member> strokes_;
};

}  // namespace biotope
