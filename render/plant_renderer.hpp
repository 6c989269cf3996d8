#pragma once

#include <memory>
#include <optional>

#include "render/frame.hpp"
#include "render/plant_blocks.hpp"
#include "render/plant_kinds.hpp"
#include "render/plant_model_maker.hpp"
#include "render/plant_selection.hpp"
#include "render/terrain_renderer.hpp"
#include "render/woody_blocks.hpp"

namespace biotope {

/// What of the plants is shown, and how.
struct PlantLook {
  int month = 5;
  SpeciesVisibility visible;
  float quality = 1;
};

/// Draws the plants: near ones as meshes, farther ones as pictures that face the eye, beyond that the ground's canopy colour
/// stands for them. Each gives way to the next dot by dot. Woody plants lie on the graphics side block by block; what is near is
/// chosen anew in every frame.
class PlantRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PlantRenderer>> create();

  /// `lines` is the water and the trails that the ground shows with the snapshot. Unless it has to be `at_once`, another thread
  /// finds what changed.
  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines, bool at_once);
  /// Goes on with what other threads find and make for what was prepared last, without waiting for them. True when all of it is
  /// there.
  bool advance();
  /// Builds every block that an eye there needs, on all threads.
  void finish_loading(const PlantLook& look, const glm::dvec3& eye);
  /// Waits for missing blocks for at most `budget_ms`, and chooses what is drawn. Call before the frame's other draws. Returns
  /// false when blocks are still missing.
  bool prepare(const PlantLook& look, const glm::dvec3& eye, const FrameUniforms& frame, const Frustum& frustum,
               double budget_ms);
  /// Draws the shade of crowns around the eye into a texture and binds it to TerrainRenderer::canopy_shade_unit.
  /// `area` is what FrameUniforms::shade_area must hold.
  DrawCount draw_shade(const glm::vec4& area, const glm::vec3& light_direction);
  /// The square that is shaded around an eye `above` metres over the ground: west, south, side in metres, strength.
  [[nodiscard]] static glm::vec4 shade_area(const glm::dvec3& eye, double above);
  /// `shadows`: they are read from the ShadowMap that is bound.
  DrawCount draw(bool shadows) const;

  /// Distances over which plants give way to the ground's canopy colour, m.
  [[nodiscard]] glm::vec2 canopy_range() const { return {selection_.levels[0].far_from, selection_.levels[0].far_to}; }
  /// What throws shadows.
  [[nodiscard]] const PlantBlocks& blocks() const { return blocks_; }
  [[nodiscard]] const PlantArena& arena() const { return arena_; }
  [[nodiscard]] const WoodyBlocks& woody() const { return woody_; }
  [[nodiscard]] const PlantKinds& kinds() const { return kinds_; }
  /// Metres around the eye within which a stratum's plants throw shade; 0 where they are not seen.
  [[nodiscard]] float shading_reach(Stratum stratum) const { return shading_reach_[std::size_t(stratum)]; }
  /// Where they stand.
  [[nodiscard]] const PlantPlacement& placement() const { return blocks_.placement(); }
  [[nodiscard]] std::size_t plants_drawn() const { return selection_.count; }
  /// Memory of instances on both sides, and what it may become.
  [[nodiscard]] std::size_t bytes() const { return blocks_.bytes() + arena_.bytes() + streamed_bytes_; }
  [[nodiscard]] std::size_t most_bytes() const { return blocks_.most_bytes() + arena_.most_bytes() + streamed_bytes_; }

 private:
  PlantRenderer() = default;
  [[nodiscard]] bool sees(Stratum stratum, const PlantBudget& budget, const glm::dvec3& eye) const;
  /// Builds what was prepared, and waits for it until then.
  bool build(std::chrono::steady_clock::time_point until);
  void show(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines, bool at_once);
  /// Goes over to the snapshot whose models are being made, when they are there; waits for them until then.
  bool follow_models(std::chrono::steady_clock::time_point until, UploadBudget upload);
  void upload_selection();
  [[nodiscard]] std::vector<FarDraw> shading_blocks(const glm::vec4& area) const;
  /// A list of plants, and the mesh that is drawn for them.
  struct MeshList {
    const PlantMeshBuffers* mesh = nullptr;
    const PlantKind* kind = nullptr;
    std::span<const PlantInstance> plants;
    std::size_t first = 0;  ///< in instances_
    glm::vec2 level{0};
    std::size_t first_command = 0;
    std::size_t commands = 0;
  };
  [[nodiscard]] std::vector<MeshList> mesh_lists() const;
  DrawCount draw_meshes(const ShaderProgram& program) const;
  DrawCount draw_tufts(const ShaderProgram& program) const;
  DrawCount draw_far() const;

  std::shared_ptr<const MapsSnapshot> snapshot_;
  /// What comes after it, as soon as the models of its plants are made.
  struct Coming {
    std::shared_ptr<const MapsSnapshot> snapshot;
    std::shared_ptr<const GroundLines> lines;
  };
  std::optional<Coming> coming_;
  PlantModelMaker models_;
  /// Models that are made and are being uploaded.
  std::shared_ptr<const PlantModels> made_;
  PlantKinds kinds_;
  PlantBlocks blocks_;
  PlantArena arena_;
  WoodyBlocks woody_;
  PlantSelection selection_;
  ShaderProgram mesh_program_;
  ShaderProgram tuft_program_;
  /// The same with shadows.
  ShaderProgram shadowed_mesh_program_;
  ShaderProgram shadowed_tuft_program_;
  ShaderProgram far_program_;
  ShaderProgram shade_program_;
  /// Plants chosen for this frame, one list after the other.
  Buffer instances_;
  Buffer far_draws_;
  Buffer mesh_draws_;
  Buffer shade_draws_;
  VertexArray far_array_;
  VertexArray shade_array_;
  Texture shade_;
  Framebuffer shade_framebuffer_;
  std::size_t streamed_bytes_ = 0;
  /// What the shade texture shows.
  glm::vec4 shaded_area_{0};
  glm::vec3 shaded_light_{0};
  /// Metres around the eye from which plants throw shade, by stratum; 0 where they are not seen.
  std::array<float, strata> shading_reach_{};
  bool complete_ = false;
  /// Where the eye was and how far it saw plants, by stratum (0: none), when they were prepared.
  glm::dvec3 prepared_eye_{0};
  std::array<float, strata> prepared_reach_{};
};

/// Draws a square for plants of the arena, block by block; returns how many.
std::size_t draw_blocks(const VertexArray& array, const PlantArena& arena, const Buffer& commands,
                        std::span<const FarDraw> blocks);

}  // namespace biotope
