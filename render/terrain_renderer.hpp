#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/ground_maps.hpp"
#include "render/line_field.hpp"
#include "render/shader_program.hpp"
#include "render/terrain_mesh.hpp"

namespace biotope {

/// What of the ground is shown, and how.
struct TerrainLook {
  int month = 5;
  SpeciesVisibility visible;
  bool water = true;
  bool trails = true;
  float quality = 1;
  /// Crowns are painted on the ground from `canopy_from` metres on, wholly from `canopy_whole`; strength 0 shows none.
  float canopy_from = 700;
  float canopy_whole = 1100;
  float canopy_strength = 1;
  /// Brush ring: x, y, radius in metres.
  std::optional<glm::vec3> brush;
};

struct DrawCount {
  int draw_calls = 0;
  std::size_t triangles = 0;
};

/// Draws the ground with its water and trails. Textures are made from the snapshot, and made again only where it changed.
class TerrainRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<TerrainRenderer>> create();

  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot);
  /// Brings the textures up to date with snapshot, season and light. Call before draw, with a snapshot set. A new ground is made whole at once;
  /// what trails, water and plants change comes one piece a call, so that no frame waits for all of it. False while pieces are left.
  bool prepare(const TerrainLook& look, const glm::vec3& light_direction);
  /// Makes the next prepare() bring everything up to date.
  void prepare_whole() { whole_ = true; }
  DrawCount draw(const TerrainLook& look, const glm::dvec3& eye, const Frustum& frustum) const;

  /// Binds height and sunlight textures (units 0 and 6), which plants and animals read too.
  void bind_shared() const;
  /// The tileable noise texture.
  [[nodiscard]] GLuint detail() const { return detail_.name(); }
  /// Ground as it is drawn, m.
  [[nodiscard]] const Grid<float>& surface() const { return surface_; }
  [[nodiscard]] glm::vec2 height_range() const { return bounds_.whole(); }
  /// Unit that holds the shade of crowns (bound by whoever draws it).
  static constexpr GLuint canopy_shade_unit = 7;

 private:
  TerrainRenderer() = default;
  void make_patch();
  void make_surface();
  void make_lines();
  void make_shore();
  void colour(const TerrainLook& look);
  void upload_colours(const Rect& texels);
  void shade(const glm::vec3& light_direction);
  [[nodiscard]] std::vector<Rect> changed_texels() const;
  [[nodiscard]] int variant(const GroundPatch& patch, const TerrainLook& look, const glm::dvec3& eye) const;
  void set_look(const ShaderProgram& program, const TerrainLook& look) const;

  std::shared_ptr<const MapsSnapshot> snapshot_;
  /// The snapshot whose covers the colours show.
  std::shared_ptr<const MapsSnapshot> coloured_;
  bool whole_ = true;
  bool surface_stale_ = true;
  bool shade_stale_ = true;
  bool lines_stale_ = true;
  bool colours_stale_ = true;
  int coloured_month_ = -1;
  SpeciesVisibility coloured_visible_;
  glm::vec3 shaded_light_{0};

  int stride_ = 1;
  Grid<float> surface_;
  Grid<float> thin_surface_;
  /// Where water is drawn, kept while the water stays: trails change far more often.
  ShoreMap shore_;
  std::shared_ptr<const Hydrology> shore_of_;
  HeightBounds bounds_;
  GroundColours colours_;
  /// Squares of patch_cells cells with water in them or near, counted from the south-west.
  Grid<std::uint8_t> near_water_;
  /// By variant: 1 when water may be near, 2 when crowns are painted on the ground.
  std::array<ShaderProgram, 4> programs_;
  VertexArray patch_array_;
  Buffer patch_vertices_;
  Buffer patch_indices_;
  Buffer patch_instances_;
  GLsizei patch_index_count_ = 0;
  Texture heights_;
  Texture normals_;
  Texture ground_;
  Texture canopy_;
  Texture lines_;
  Texture sunlit_;
  Texture detail_;
};

}  // namespace biotope
