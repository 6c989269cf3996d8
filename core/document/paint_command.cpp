#include <algorithm>

#include "core/document/history.hpp"

namespace biotope {

namespace {

std::size_t sum_of_blocks(const Command& command) {
  std::size_t sum = 0;
  command.visit_blocks([&](const void*, std::size_t bytes) { sum += bytes; });
  return sum;
}

/// Changes a layer of the document; one that has become blank is removed.
template <class Change>
void change_layer(Document& document, const LayerId& id, const Change& change) {
  auto& slot = document.layers[id];
  auto layer = slot ? std::make_shared<PaintLayer>(*slot)
                    : std::make_shared<PaintLayer>(document.terrain->height.width(), document.terrain->height.height());
  change(*layer);
  if (layer->bytes() == 0) {
    document.layers.erase(id);
  } else {
    slot = std::move(layer);
  }
}

}  // namespace

PaintCommand::PaintCommand(std::string name, LayerId layer, std::vector<TileChange> changes)
    : name_(std::move(name)), layer_(std::move(layer)), changes_(std::move(changes)) {}

std::string PaintCommand::name() const { return name_; }

void PaintCommand::apply(Document& document) const {
  change_layer(document, layer_, [&](PaintLayer& layer) { changes_.apply(layer); });
}

void PaintCommand::revert(Document& document) const {
  change_layer(document, layer_, [&](PaintLayer& layer) { changes_.revert(layer); });
}

std::size_t PaintCommand::bytes() const { return own_bytes() + sum_of_blocks(*this); }
void PaintCommand::visit_blocks(const BlockVisitor& visit) const { changes_.visit_blocks(visit); }
std::size_t PaintCommand::own_bytes() const {
  return sizeof(*this) + name_.capacity() + layer_.name.capacity() + changes_.own_bytes();
}
void PaintCommand::visit_tiles(const std::function<void(PackableTiles&)>& visit) { visit(changes_); }

GroupCommand::GroupCommand(std::string name, std::vector<std::unique_ptr<Command>> commands)
    : name_(std::move(name)), commands_(std::move(commands)) {}

std::string GroupCommand::name() const { return name_; }
void GroupCommand::apply(Document& document) const {
  for (const auto& command : commands_) command->apply(document);
}
void GroupCommand::revert(Document& document) const {
  for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) (*command)->revert(document);
}
std::size_t GroupCommand::bytes() const { return own_bytes() + sum_of_blocks(*this); }
void GroupCommand::visit_blocks(const BlockVisitor& visit) const {
  for (const auto& command : commands_) command->visit_blocks(visit);
}
std::size_t GroupCommand::own_bytes() const {
  std::size_t sum = sizeof(*this) + name_.capacity() + commands_.capacity() * sizeof(commands_.front());
  for (const auto& command : commands_) sum += command->own_bytes();
  return sum;
}
void GroupCommand::visit_tiles(const std::function<void(PackableTiles&)>& visit) {
  for (const auto& command : commands_) command->visit_tiles(visit);
}

}  // namespace biotope
