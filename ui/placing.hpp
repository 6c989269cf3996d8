#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "core/movement/trails.hpp"

namespace biotope {

/// What a person can place or draw on a landscape.
enum class PlacedKind : std::uint8_t { inflow, river, lake, ford, exit, waypoint, pinned_trail, forbidden_trail };
inline constexpr int placed_kinds = 8;

/// One placed thing of a document.
struct PlacedItem {
  PlacedKind kind = PlacedKind::ford;
  std::size_t index = 0;
  bool operator==(const PlacedItem&) const = default;
};

/// A point of a placed thing that can be taken hold of.
struct PlacedHandle {
  PlacedItem item;
  std::size_t point = 0;
  PathPoint at;
};

/// Everything placed, as it is drawn: the document's, or what it becomes while something is dragged.
struct PlacedThings {
  std::vector<Inflow> inflows;
  Placements placements;
};
[[nodiscard]] PlacedThings placed_things(const Document& document);
/// Puts them into a document.
void set_placed(Document& document, const PlacedThings& things);

/// "River", "Pinned trail" ...
[[nodiscard]] const char* placed_name(PlacedKind kind);
/// Things made of a line of points rather than one.
[[nodiscard]] bool is_line(PlacedKind kind);
/// Fewest points of a line of this kind.
[[nodiscard]] std::size_t least_points(PlacedKind kind);
[[nodiscard]] std::size_t count_of(const PlacedThings& things, PlacedKind kind);
/// Its points, in cells; one for a thing without a line.
[[nodiscard]] std::vector<PathPoint> points_of(const PlacedThings& things, const PlacedItem& item);
/// Radius on the ground (m) that is drawn around its point; 0: none.
[[nodiscard]] float radius_of(const PlacedThings& things, const PlacedItem& item);

/// The handle nearest to a place, at most `reach` cells away; those of `first` win over others.
[[nodiscard]] std::optional<PlacedHandle> handle_near(const PlacedThings& things, PathPoint at, float reach,
                                                      const std::optional<PlacedItem>& first = {});
/// The thing whose line or point is nearest, at most `reach` cells away.
[[nodiscard]] std::optional<PlacedItem> item_near(const PlacedThings& things, PathPoint at, float reach);

/// Adds a thing with defaults that suit the terrain; returns it.
PlacedItem add_thing(PlacedThings& things, PlacedKind kind, std::vector<PathPoint> points, const Terrain& terrain);
void move_point(PlacedThings& things, const PlacedHandle& handle, PathPoint to, const Terrain& terrain);
/// Adds a point to a line between those it lies nearest to.
void insert_point(PlacedThings& things, const PlacedItem& item, PathPoint at);
/// Takes a point out of a line; the whole thing when too few would be left.
void remove_point(PlacedThings& things, const PlacedHandle& handle);
void remove_thing(PlacedThings& things, const PlacedItem& item);

/// A computed route under the pointer: its number and the point of it that is nearest.
struct RouteHit {
  std::size_t route = 0;
  std::size_t point = 0;
};
[[nodiscard]] std::optional<RouteHit> route_near(const TrailNetwork& trails, PathPoint at, float reach);

/// A stretch of a route pulled aside: the points around the grip moved with it, less the farther along the way they lie.
struct TrailBend {
  std::vector<PathPoint> before;
  std::vector<PathPoint> after;
  float weight = 0;  ///< of the route at the grip, kg x trips per year
};
/// The way through a grip, `reach` metres to each side: where a route ends, the one that goes on most straightly is followed.
struct TrailStretch {
  std::vector<PathPoint> points;
  std::size_t grip = 0;
  float weight = 0;
};
[[nodiscard]] TrailStretch stretch_around(const TrailNetwork& trails, const RouteHit& hit, double cell_size, double reach);

/// `reach` metres to each side of the grip move.
[[nodiscard]] TrailBend bent(const TrailStretch& stretch, PathPoint to, double cell_size, double reach);
/// Pins the bent stretch and forbids the old one.
void place_bend(PlacedThings& things, const TrailBend& bend, double cell_size);

}  // namespace biotope
