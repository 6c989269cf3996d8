#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/ground_maker.hpp"
#include "render/shader_program.hpp"
#include "render/streamed_texture.hpp"
#include "render/terrain_mesh.hpp"

namespace biotope {

/// What of the ground is shown, and how.
struct TerrainLook {
  int month = 5;
  SpeciesVisibility visible;
  bool water = true;
  bool trails = true;
  float quality = 1;
  /// Shadows are read from the ShadowMap that is bound.
  bool shadows = false;
  /// Where water mirrors what ScreenEffects::keep_for_water() bound: nearest and farthest depth of that, m. Read with shadows
  /// only.
  std::optional<glm::vec2> mirrored;
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

/// Draws the ground with its water and trails. Its picture is made on a thread of its own and uploaded a piece a frame; the one
/// before stays in sight until then.
class TerrainRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<TerrainRenderer>> create();

  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot) { snapshot_ = std::move(snapshot); }
  /// Asks for the picture of snapshot, season and light, and uploads what is there of it, for a few milliseconds. Call before
  /// draw, with a snapshot set. True when the picture shown is the one that was asked for.
  bool prepare(const TerrainLook& look, const glm::vec3& light_direction);
  /// The same, but waits until all of it is there.
  void finish(const TerrainLook& look, const glm::vec3& light_direction);
  /// True when the picture shown covers the snapshot's ground: then the functions below may be called.
  [[nodiscard]] bool ready() const { return shown_ && snapshot_ && same_extent(shown_->terrain(), snapshot_->terrain()); }
  DrawCount draw(const TerrainLook& look, const glm::dvec3& eye, const Frustum& frustum) const;

  /// Binds textures of height, ground colours and sunlight (units 0, 2 and 6), which plants and animals read too.
  void bind_shared() const;
  /// The tileable noise texture.
  [[nodiscard]] GLuint detail() const { return detail_.name(); }
  /// The picture in sight; null before the first.
  [[nodiscard]] const std::shared_ptr<const GroundPicture>& shown() const { return shown_; }
  /// Ground as it is drawn, m.
  [[nodiscard]] const Grid<float>& surface() const { return shown_->shape->surface; }
  [[nodiscard]] glm::vec2 height_range() const { return shown_->shape->bounds.whole(); }
  /// Unit that holds the shade of crowns (bound by whoever draws it).
  static constexpr GLuint canopy_shade_unit = 7;

 private:
  TerrainRenderer() = default;
  void make_patch();
  void ask(const TerrainLook& look, const glm::vec3& light_direction);
  void take(std::shared_ptr<const GroundPicture> picture);
  /// True when all of the picture that is coming in was uploaded; it is then shown.
  bool upload(UploadBudget& budget);
  [[nodiscard]] int variant(const GroundPatch& patch, const TerrainLook& look, const glm::dvec3& eye) const;
  /// Binds what the ground's shaders read, with mipmaps as the quality asks.
  void bind_ground(const TerrainLook& look) const;
  void set_look(const ShaderProgram& program, const TerrainLook& look) const;
  /// Draws `count` patches from `first` on.
  void draw_patches(const ShaderProgram& program, const TerrainLook& look, std::size_t first, std::size_t count) const;

  static constexpr Sampling mirrored_mipmapped{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT};
  static constexpr Sampling mirrored{GL_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT};

  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::optional<GroundRequest> asked_;
  std::shared_ptr<const GroundPicture> shown_;
  /// Made, and being uploaded.
  std::shared_ptr<const GroundPicture> coming_;
  /// By variant: 1 when water may be near, 2 when crowns are painted on the ground; 4 more with small things, 8 with these and
  /// shadows.
  std::array<ShaderProgram, 12> programs_;
  /// At low quality the ground is drawn without its water, which is then laid over it.
  ShaderProgram water_program_;
  VertexArray patch_array_;
  Buffer patch_vertices_;
  Buffer patch_indices_;
  Buffer patch_instances_;
  GLsizei patch_index_count_ = 0;
  StreamedTexture<float> heights_{mirrored};
  StreamedTexture<Rgba> normals_{mirrored_mipmapped};
  StreamedTexture<Rgba> ground_{mirrored_mipmapped};
  StreamedTexture<Rgba> canopy_{mirrored_mipmapped};
  StreamedTexture<Rg> lines_{mirrored_mipmapped};
  StreamedTexture<Rgba> currents_{mirrored};
  StreamedTexture<std::uint8_t> sunlit_{mirrored};
  Texture detail_;
  GroundMaker maker_;
};

}  // namespace biotope
