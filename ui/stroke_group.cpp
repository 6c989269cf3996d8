#include "ui/stroke_group.hpp"

#include <numeric>

namespace biotope {

GroupCommand::GroupCommand(std::string name, std::vector<std::unique_ptr<Command>> parts)
    : name_(std::move(name)), parts_(std::move(parts)) {}

void GroupCommand::apply(Document& document) const {
  for (const auto& part : parts_) part->apply(document);
}

void GroupCommand::revert(Document& document) const {
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) (*part)->revert(document);
}

std::size_t GroupCommand::bytes() const {
  return std::accumulate(parts_.begin(), parts_.end(), std::size_t(0),
                         [](std::size_t sum, const auto& part) { return sum + part->bytes(); });
}

void StrokeGroup::begin(const PaintGround& ground) {
  strokes_.push_back({ground.computed, Stroke(ground.layer, ground.computed.get())});
}

bool StrokeGroup::move_to(Document& document, const Brush& brush, float x, float y) {
  bool changed = false;
  for (Member& member : strokes_) changed = !member.stroke.move_to(document, brush, x, y).empty() || changed;
  return changed;
}

std::vector<std::unique_ptr<Command>> StrokeGroup::finish(const Document& document) {
  std::vector<std::unique_ptr<Command>> commands;
  for (Member& member : strokes_) {
    if (auto command = member.stroke.finish(document)) commands.push_back(std::move(command));
  }
  strokes_.clear();
  return commands;
}

}  // namespace biotope
