#include "core/document/history.hpp"

#include <cassert>
#include <utility>

namespace biotope {

namespace {

/// Puts tiles into a layer of the document; a layer that has become blank is removed.
template <class TileOf>
void place_tiles(Document& document, const LayerId& id, const std::vector<PaintCommand::TileChange>& changes,
                 const TileOf& tile_of) {
  auto& slot = document.layers[id];
  const int width = document.terrain->height.width();
  const int height = document.terrain->height.height();
  auto layer = slot ? std::make_shared<PaintLayer>(*slot) : std::make_shared<PaintLayer>(width, height);
  for (const auto& change : changes) layer->set_tile(change.tile, tile_of(change));
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
  place_tiles(document, layer_, changes_, [](const TileChange& change) { return change.after; });
}

void PaintCommand::revert(Document& document) const {
  place_tiles(document, layer_, changes_, [](const TileChange& change) { return change.before; });
}

std::size_t PaintCommand::bytes() const {
  std::size_t sum = sizeof(*this) + changes_.size() * sizeof(TileChange);
  for (const auto& change : changes_) {
    sum += (change.before ? sizeof(PaintLayer::Tile) : 0) + (change.after ? sizeof(PaintLayer::Tile) : 0);
  }
  return sum;
}

DocumentCommand::DocumentCommand(std::string name, Document before, Document after)
    : name_(std::move(name)), before_(std::move(before)), after_(std::move(after)) {}

std::string DocumentCommand::name() const { return name_; }
void DocumentCommand::apply(Document& document) const { document = after_; }
void DocumentCommand::revert(Document& document) const { document = before_; }

std::size_t DocumentCommand::bytes() const {
  std::size_t sum = sizeof(*this);
  if (before_.terrain != after_.terrain) {
    sum += (before_.terrain ? before_.terrain->height.size() * sizeof(float) : 0);
  }
  for (const auto& [id, layer] : before_.layers) {
    const auto kept = after_.layers.find(id);
    if (layer && (kept == after_.layers.end() || kept->second != layer)) sum += layer->bytes();
  }
  return sum;
}

void History::perform(Document& document, std::unique_ptr<Command> command) {
  command->apply(document);
  record(std::move(command));
}

void History::record(std::unique_ptr<Command> command) {
  assert(command);
  commands_.erase(commands_.begin() + std::ptrdiff_t(position_), commands_.end());
  commands_.push_back(std::move(command));
  position_ = commands_.size();
  trim();
}

bool History::undo(Document& document) {
  if (!can_undo()) return false;
  commands_[--position_]->revert(document);
  return true;
}

bool History::redo(Document& document) {
  if (!can_redo()) return false;
  commands_[position_++]->apply(document);
  return true;
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (const auto& command : commands_) sum += command->bytes();
  return sum;
}

std::vector<std::string> History::names() const {
  std::vector<std::string> names;
  for (const auto& command : commands_) names.push_back(command->name());
  return names;
}

void History::clear() {
  commands_.clear();
  position_ = 0;
}

void History::trim() {
  // The newest step always stays, however big: a person must be able to take back what was just done.
  std::size_t held = bytes();
  while (held > budget_ && commands_.size() > 1 && position_ > 1) {
    held -= commands_.front()->bytes();
    commands_.pop_front();
    --position_;
  }
}

}  // namespace biotope
