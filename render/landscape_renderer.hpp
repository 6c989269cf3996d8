#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/status.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "render/animal_pick.hpp"
#include "render/camera.hpp"
#include "render/weather.hpp"

namespace biotope {

class PlantPlacement;

/// How the 3D view is drawn.
struct LandscapeOptions {
  double hour = 10.5;  ///< local solar time
  int month = 5;       ///< 0 is January; default: early summer, late morning
  Weather weather;
  /// Time that moves leaves, waves, rain and clouds, s. The same time shows the same picture.
  double seconds = 0;
  bool plants = true;
  bool animals = true;
  bool trails = true;
  bool water = true;
  /// Multiplies distances and counts of plants: 0.5 low, 1 medium, 2 high.
  float quality = 1;
  /// Shadows of single trees and animals, from quality 2 on; below, the shade of crowns is drawn all the same.
  bool shadows = true;
  /// Edges are smoothed, from quality 2 on; corners and what stands in the grass are shaded, at quality 4.
  bool smooth_edges = true;
  bool occlusion = true;
  /// Water mirrors the plants around it, from quality 2 on; otherwise only their colour.
  bool reflections = true;
  /// How long a picture waits for plants that are being made, s.
  double patience = 0.008;
  /// Per species number of the web: false hides it. Empty shows all.
  std::vector<bool> visible_species;
  /// Brush ring on the ground: cell x, y, radius in cells.
  std::optional<glm::vec3> brush;
  /// For pictures made in tiles: the pixel of the whole picture (which draw's width and height speak of) that is the lower left
  /// one of the framebuffer. What is nearer to an edge of the framebuffer than tile_margin() is right only at the whole's edges.
  glm::ivec2 corner{0};

  bool operator==(const LandscapeOptions&) const = default;
};

/// Pixels around a tile that must be drawn with it, so that it is a part of the whole picture: as far as effects look.
[[nodiscard]] int tile_margin(const LandscapeOptions& options, int whole_height);

struct LandscapeStatistics {
  int draw_calls = 0;
  std::size_t triangles = 0;
  std::size_t plants = 0;
  std::size_t animals = 0;
  /// Memory of plants and of the runs of herds, and the most it may become.
  std::size_t instance_bytes = 0;
  std::size_t most_instance_bytes = 0;
};

/// Draws a MapsSnapshot in 3D: terrain, water, sky, trails, instanced procedural plants with level of detail, herds at their
/// place on the clock. Owns its OpenGL objects; needs a current OpenGL 4.5 core context for its whole life. Draws only; changes
/// nothing in the model.
class LandscapeRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<LandscapeRenderer>> create();
  ~LandscapeRenderer();
  LandscapeRenderer(const LandscapeRenderer&) = delete;
  LandscapeRenderer& operator=(const LandscapeRenderer&) = delete;

  /// Takes a newer snapshot; uploads only what changed (pointers differ).
  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot);
  /// Brings in what was made in the background since the last call, for a few milliseconds; draw() does it where it was not
  /// called before. True when draw() would show something that it did not show before.
  bool bring_in(const LandscapeOptions& options);
  /// After bring_in(): false while ground or plants of the last view drawn are still being made, so that a later picture would
  /// show more.
  [[nodiscard]] bool all_made() const;
  /// Draws into the framebuffer bound now, over width x height pixels.
  void draw(const Camera& camera, const LandscapeOptions& options, int width, int height);
  /// Waits until everything is there that draw() would show for that camera only after some frames (ground and plants): for
  /// pictures and tests. draw() itself never waits; the ground is made on a thread of its own, and a few milliseconds a frame
  /// bring in what is ready.
  void finish_loading(const Camera& camera, const LandscapeOptions& options);
  /// False while ground, plants or shadows of the last view drawn are still being made: draw again soon.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] const LandscapeStatistics& statistics() const;
  /// Nearest and farthest depth of the last draw(), m: what its depth buffer's 0 and 1 stand for.
  [[nodiscard]] glm::vec2 depth_planes() const;
  /// The animals of the last draw(): those in the picture, as far as they can be told apart.
  [[nodiscard]] std::span<const AnimalAt> animals() const;
  /// Where the plants that are drawn stand, and of which snapshot; it has no snapshot before the first picture of the ground.
  [[nodiscard]] const PlantPlacement& plants() const;
  /// Where an animal is at an hour, in the picture or not: what a camera that follows it needs before it draws. Nothing when
  /// there is no such animal, or before the first picture of the ground.
  [[nodiscard]] std::optional<AnimalAt> animal(int plan, int member, double hour);

 private:
  LandscapeRenderer();
  struct State;
  std::unique_ptr<State> state_;
};

/// Height of the ground at metres (x east, y north of the south-west corner), bilinear.
[[nodiscard]] float ground_height(const Terrain& terrain, double x, double y);
/// Height of a place (metres from the south-west corner, z above sea level) over the ground, or over the water on it, m.
[[nodiscard]] double height_above_surface(const MapsSnapshot& snapshot, const glm::dvec3& place);

/// Where a ray from `origin` along `direction` first meets the ground within `reach` metres.
[[nodiscard]] std::optional<glm::dvec3> pick_ground(const Terrain& terrain, const glm::dvec3& origin, const glm::vec3& direction,
                                                    double reach = 20000);

/// A good first view of a landscape: near water, looking along the valley, at a few metres above the ground.
[[nodiscard]] Camera first_view(const MapsSnapshot& snapshot);
/// A view of the whole landscape from above, at an angle.
[[nodiscard]] Camera overview(const MapsSnapshot& snapshot);

}  // namespace biotope
