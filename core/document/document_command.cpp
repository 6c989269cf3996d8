#include <cassert>
#include <optional>

#include "core/document/history.hpp"

namespace biotope {

namespace {

template <class T>
using MapPointer = std::shared_ptr<const TiledMap<T>>;

/// A change of one tiled map that may not be there: by its tiles where both states have the same size, else as a whole.
template <class T>
class MapChange {
 public:
  MapChange(MapPointer<T> before, MapPointer<T> after) {
    const TiledMap<T>* const present = before ? before.get() : after.get();
    const TiledMap<T> none(present->width(), present->height());
    const TiledMap<T>& from = before ? *before : none;
    const TiledMap<T>& to = after ? *after : none;
    const bool alike =
        from.width() == to.width() && from.height() == to.height() && from.background() == T{} && to.background() == T{};
    if (!alike) {
      whole_ = {std::move(before), std::move(after)};
      return;
    }
    size_ = {from.width(), from.height()};
    there_ = {before != nullptr, after != nullptr};
    std::vector<typename TileChanges<T>::Change> changes;
    for (std::size_t i = 0; i < from.tile_count(); ++i) {
      if (from.tile(i) != to.tile(i)) changes.push_back({i, from.tile(i), to.tile(i)});
    }
    tiles_.emplace(std::move(changes));
  }

  [[nodiscard]] MapPointer<T> applied(const MapPointer<T>& map) const {
    if (!tiles_) return whole_[1];
    if (!there_[1]) return gone(map, [&](TiledMap<T>& shown) { tiles_->apply(shown); });
    return changed(map, [&](TiledMap<T>& shown) { tiles_->apply(shown); });
  }
  [[nodiscard]] MapPointer<T> reverted(const MapPointer<T>& map) const {
    if (!tiles_) return whole_[0];
    if (!there_[0]) return gone(map, [&](TiledMap<T>& shown) { tiles_->revert(shown); });
    return changed(map, [&](TiledMap<T>& shown) { tiles_->revert(shown); });
  }

  void visit_blocks(const BlockVisitor& visit) const {
    if (tiles_) tiles_->visit_blocks(visit);
    for (const auto& map : whole_) {
      for (std::size_t i = 0; map && i < map->tile_count(); ++i) {
        if (map->tile(i)) visit(map->tile(i).get(), sizeof(typename TiledMap<T>::Tile));
      }
    }
  }
  [[nodiscard]] std::size_t own_bytes() const {
    std::size_t sum = sizeof(*this) + (tiles_ ? tiles_->own_bytes() : 0);
    for (const auto& map : whole_) sum += map ? map->tile_count() * sizeof(typename TiledMap<T>::TilePointer) : 0;
    return sum;
  }
  void visit_tiles(const std::function<void(PackableTiles&)>& visit) {
    if (tiles_) visit(*tiles_);
  }

 private:
  template <class Change>
  [[nodiscard]] MapPointer<T> changed(const MapPointer<T>& map, const Change& change) const {
    auto shown = map ? std::make_shared<TiledMap<T>>(*map) : std::make_shared<TiledMap<T>>(size_[0], size_[1]);
    change(*shown);
    return shown;
  }
  /// Packed tiles need to see the map even where it goes.
  template <class Change>
  [[nodiscard]] MapPointer<T> gone(const MapPointer<T>& map, const Change& change) const {
    static_cast<void>(changed(map, change));
    return nullptr;
  }

  std::array<MapPointer<T>, 2> whole_;
  std::optional<TileChanges<T>> tiles_;
  std::array<int, 2> size_{};
  std::array<bool, 2> there_{};
};

std::size_t bytes_of(const std::vector<PathPoint>& points) { return points.capacity() * sizeof(PathPoint); }

std::size_t bytes_of(const Placements& placements) {
  std::size_t sum = 0;
  for (const auto& river : placements.water.rivers) sum += sizeof(river) + bytes_of(river.course);
  for (const auto& lake : placements.water.lakes) sum += sizeof(lake) + bytes_of(lake.shore);
  for (const auto& trail : placements.places.pinned_trails) sum += sizeof(trail) + bytes_of(trail.points);
  for (const auto& trail : placements.places.forbidden_trails) sum += sizeof(trail) + bytes_of(trail.points);
  for (const auto& plan : placements.plans)
    sum += sizeof(plan) + plan.species.capacity() + plan.stops.capacity() * sizeof(PlanStopEdit);
  const Places& places = placements.places;
  return sum + places.fords.capacity() * sizeof(PlacedFord) + places.exits.capacity() * sizeof(PlacedExit) +
         places.waypoints.capacity() * sizeof(Waypoint);
}

/// What a document without rasters takes for itself, about.
std::size_t bytes_of(const Document& document) {
  // A node of std::map is about this much more than its value.
  constexpr std::size_t node = 48;
  std::size_t sum = document.title.capacity() + document.inflows.capacity() * sizeof(Inflow);
  const Climate& climate = document.climate;
  sum += climate.name.capacity() + climate.title.capacity() + climate.description.capacity() + climate.source.capacity();
  sum += document.use_proportions.size() * node;
  for (const auto& [id, state] : document.layer_states) sum += node + sizeof(id) + id.name.capacity();
  for (const auto& maps : document.given_environment.monthly) sum += maps.capacity() * sizeof(maps.front());
  return sum + bytes_of(document.placements);
}

/// Rasters that only one of the two documents has.
void visit_replaced(const Document& one, const Document& other, const BlockVisitor& visit) {
  if (one.terrain && one.terrain != other.terrain) {
    visit(one.terrain.get(), one.terrain->height.size() * sizeof(float) + one.terrain->voids.size());
  }
  for (std::size_t r = 0; r < one.given_environment.monthly.size(); ++r) {
    if (one.given_environment.monthly[r] == other.given_environment.monthly[r]) continue;
    for (const auto& map : one.given_environment.monthly[r]) {
      if (map) visit(map.get(), map->size() * sizeof(float));
    }
  }
  const auto& geology = one.given_environment.geology;
  if (geology && geology != other.given_environment.geology) visit(geology.get(), geology->size() * sizeof(Geology));
}

}  // namespace

class DocumentCommand::RasterChanges {
 public:
  /// Takes the layers and the masks out of both documents.
  RasterChanges(Document& before, Document& after) {
    if (before.selection != after.selection) selection_.emplace(before.selection, after.selection);
    if (before.locked_area != after.locked_area) locked_area_.emplace(before.locked_area, after.locked_area);
    const auto layer_of = [](const Document& document, const LayerId& id) {
      const auto found = document.layers.find(id);
      return found == document.layers.end() ? nullptr : found->second;
    };
    for (const auto* document : {&before, &after}) {
      for (const auto& [id, layer] : document->layers) {
        const auto old = layer_of(before, id);
        const auto now = layer_of(after, id);
        if (old != now && !layers_.contains(id)) layers_.emplace(id, MapChange<Paint>(old, now));
      }
    }
    for (auto* document : {&before, &after}) {
      document->layers.clear();
      document->selection.reset();
      document->locked_area.reset();
    }
  }

  [[nodiscard]] bool empty() const { return layers_.empty() && !selection_ && !locked_area_; }

  void change(Document& document, bool forwards) const {
    const auto go = [&](const auto& change, const auto& map) { return forwards ? change.applied(map) : change.reverted(map); };
    if (selection_) document.selection = go(*selection_, document.selection);
    if (locked_area_) document.locked_area = go(*locked_area_, document.locked_area);
    for (const auto& [id, change] : layers_) {
      const auto found = document.layers.find(id);
      auto layer = go(change, found == document.layers.end() ? nullptr : found->second);
      if (layer) {
        document.layers[id] = std::move(layer);
      } else {
        document.layers.erase(id);
      }
    }
  }

  void visit_blocks(const BlockVisitor& visit) const {
    if (selection_) selection_->visit_blocks(visit);
    if (locked_area_) locked_area_->visit_blocks(visit);
    for (const auto& [id, change] : layers_) change.visit_blocks(visit);
  }
  [[nodiscard]] std::size_t own_bytes() const {
    std::size_t sum = sizeof(*this) + (selection_ ? selection_->own_bytes() : 0) + (locked_area_ ? locked_area_->own_bytes() : 0);
    for (const auto& [id, change] : layers_) sum += sizeof(id) + id.name.capacity() + change.own_bytes();
    return sum;
  }
  void visit_tiles(const std::function<void(PackableTiles&)>& visit) {
    if (selection_) selection_->visit_tiles(visit);
    if (locked_area_) locked_area_->visit_tiles(visit);
    for (auto& [id, change] : layers_) change.visit_tiles(visit);
  }

 private:
  std::optional<MapChange<std::uint8_t>> selection_;
  std::optional<MapChange<std::uint8_t>> locked_area_;
  std::map<LayerId, MapChange<Paint>> layers_;
};

DocumentCommand::DocumentCommand(std::string name, Document before, Document after)
    : name_(std::move(name)), before_(std::move(before)), after_(std::move(after)) {
  auto rasters = std::make_unique<RasterChanges>(before_, after_);
  if (!rasters->empty()) rasters_ = std::move(rasters);
}

DocumentCommand::~DocumentCommand() = default;

std::string DocumentCommand::name() const { return name_; }

namespace {

/// Everything but layers, selection and locked area.
void take_parts(Document& document, const Document& parts) {
  auto layers = std::move(document.layers);
  auto selection = std::move(document.selection);
  auto locked_area = std::move(document.locked_area);
  document = parts;
  document.layers = std::move(layers);
  document.selection = std::move(selection);
  document.locked_area = std::move(locked_area);
}

}  // namespace

void DocumentCommand::apply(Document& document) const {
  take_parts(document, after_);
  if (rasters_) rasters_->change(document, true);
}

void DocumentCommand::revert(Document& document) const {
  take_parts(document, before_);
  if (rasters_) rasters_->change(document, false);
}

std::size_t DocumentCommand::bytes() const {
  std::size_t sum = own_bytes();
  visit_blocks([&](const void*, std::size_t bytes) { sum += bytes; });
  return sum;
}

void DocumentCommand::visit_blocks(const BlockVisitor& visit) const {
  visit_replaced(before_, after_, visit);
  visit_replaced(after_, before_, visit);
  if (rasters_) rasters_->visit_blocks(visit);
}

std::size_t DocumentCommand::own_bytes() const {
  return sizeof(*this) + name_.capacity() + bytes_of(before_) + bytes_of(after_) + (rasters_ ? rasters_->own_bytes() : 0);
}

void DocumentCommand::visit_tiles(const std::function<void(PackableTiles&)>& visit) {
  if (rasters_) rasters_->visit_tiles(visit);
}

bool DocumentCommand::absorb(const Command& later) {
  const auto* const other = dynamic_cast<const DocumentCommand*>(&later);
  if (other == nullptr || other->rasters_) return false;
  after_ = other->after_;
  return true;
}

}  // namespace biotope
