#include "render/plant_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/plant_leaves.hpp"

namespace biotope {

namespace {

constexpr int far_views = 3;
/// Heights from which the far pictures are taken (radians above the horizon); the same as in plant_far.vert.
constexpr std::array<float, far_views> elevations{0.17453F, 0.78540F, 1.30900F};

glm::vec3 linear(const std::array<float, 3>& srgb) {
  const auto c = linear_colour(srgb);
  return {c[0], c[1], c[2]};
}

/// Bark, our choice: white for birch, reddish for pines, else grey-brown.
glm::vec3 wood_colour(const std::string& model) {
  if (model == "birch") return linear({0.80F, 0.79F, 0.75F});
  if (model == "conifer" || model == "mountain-pine") return linear({0.47F, 0.39F, 0.33F});
  if (model == "alder") return linear({0.46F, 0.43F, 0.385F});
  return linear({0.49F, 0.45F, 0.40F});
}

/// Bark of the upper half: Scots pines and their like are orange there.
glm::vec3 high_wood_colour(const PlantShape& shape) {
  if (shape.model == "conifer" && shape.trunk_fraction > 0.25F) return linear({0.60F, 0.42F, 0.29F});
  return wood_colour(shape.model);
}

Texture leaf_texture() {
  const std::vector<Grid<Rgba>> pictures = leaf_pictures();
  Texture texture = make_texture_array(GL_RGBA8, leaf_picture_side, leaf_picture_side, int(pictures.size()), 7,
                                       {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::vector<Grid<Rgba>> levels = leaf_mipmaps(pictures[i]);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const Grid<Rgba>& texels = levels[level];
      glTextureSubImage3D(texture.name(), GLint(level), 0, 0, GLint(i), texels.width(), texels.height(), 1, GL_RGBA,
                          GL_UNSIGNED_BYTE, texels.cells().data());
    }
  }
  return texture;
}

/// What the shaders know of all kinds: `Kinds` of shaders/landscape/plant_kinds.glsl.
struct KindUniforms {
  std::array<glm::vec4, most_plant_kinds> form{};
  std::array<glm::vec4, most_plant_kinds> fresh{};
  std::array<glm::vec4, most_plant_kinds> turned{};
};

glm::vec3 leaf_in_sward(const PlantKind& kind, const std::array<float, 3>& colour) {
  const auto c = kind.stratum == Stratum::herb ? meadow_colour(colour) : colour;
  return {c[0], c[1], c[2]};
}

}  // namespace

PlantMeshBuffers upload(const PlantMesh& mesh) {
  PlantMeshBuffers out;
  out.vertices = make_static_buffer(std::as_bytes(std::span(mesh.vertices)));
  out.indices = make_static_buffer(std::as_bytes(std::span(mesh.indices)));
  out.array = make_vertex_array();
  out.index_count = GLsizei(mesh.indices.size());
  glVertexArrayElementBuffer(out.array.name(), out.indices.name());
  glVertexArrayVertexBuffer(out.array.name(), 0, out.vertices.name(), 0, sizeof(PlantVertex));
  float_attribute(out.array, 0, 0, 3, offsetof(PlantVertex, position));
  float_attribute(out.array, 1, 0, 3, offsetof(PlantVertex, normal));
  float_attribute(out.array, 2, 0, 2, offsetof(PlantVertex, uv));
  float_attribute(out.array, 3, 0, 4, offsetof(PlantVertex, picture));
  instance_attributes(out.array);
  return out;
}

void instance_attributes(const VertexArray& array) {
  float_attribute(array, 4, 1, 4, 0);
  float_attribute(array, 5, 1, 4, offsetof(PlantInstance, turn));
  glVertexArrayBindingDivisor(array.name(), 1, 1);
}

void set_wood(const ShaderProgram& program, const PlantKind& kind) {
  program.set("wood_colour", wood_colour(kind.shape.model));
  program.set("high_wood_colour", high_wood_colour(kind.shape));
}

void set_flowers(const ShaderProgram& program, const PlantKind& kind) {
  program.set("flower_colour", linear(kind.shape.flower_colour));
  program.set("bloom", kind.bloom);
}

Result<PlantKinds> PlantKinds::create() {
  auto bake = load_shader_program("landscape/plant_bake.vert", "landscape/plant_bake.frag");
  if (!bake) return tl::unexpected(bake.error());
  PlantKinds kinds;
  kinds.bake_ = std::move(*bake);
  kinds.leaves_ = leaf_texture();
  kinds.uniforms_ = make_buffer();
  return kinds;
}

void PlantKinds::set_web(const FoodWeb& web) {
  kinds_.clear();
  month_ = -1;
  if (web.levels.empty()) return;
  for (std::size_t i = 0; i < web.levels[0].size() && i < most_plant_kinds; ++i) {
    PlantKind kind;
    kind.species = web.levels[0][i];
    const PlantTraits& plant = web.species[std::size_t(kind.species)].plant();
    kind.stratum = plant.stratum;
    kind.shape = plant.shape;
    for (std::size_t model = 0; model < plant_models; ++model) {
      const std::uint64_t seed = 0x6b696e64ULL + plant_models * i + model;
      const PlantMesh near = make_plant_mesh(plant.shape, PlantDetail::near, seed);
      const PlantExtent extent = extent_of(near);
      kind.extent = {std::max(kind.extent.radius, extent.radius), std::max(kind.extent.height, extent.height)};
      kind.near[model] = upload(near);
      kind.mid[model] = upload(make_plant_mesh(plant.shape, PlantDetail::mid, seed));
    }
    kinds_.push_back(std::move(kind));
  }
  const auto layers = int(std::max<std::size_t>(1, kinds_.size())) * plant_models * far_views;
  const Sampling smooth{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE};
  // Mipmaps down to 4 texels: below that a plant is a dot, and species must not run into each other.
  far_pictures_ = make_texture_array(GL_RGBA8, picture_side(), picture_side(), layers, 6, smooth);
  far_surfaces_ = make_texture_array(GL_RGBA8, picture_side(), picture_side(), layers, 6, smooth);
}

void PlantKinds::set_month(const FoodWeb& web, int month) {
  if (month == month_ || kinds_.empty()) return;
  month_ = month;
  // Meadows flower from April to August (our choice).
  constexpr std::array<float, 12> bloom{0, 0, 0.05F, 0.2F, 0.4F, 0.42F, 0.32F, 0.2F, 0.1F, 0.03F, 0, 0};
  for (PlantKind& kind : kinds_) {
    kind.bloom = bloom[std::size_t(std::clamp(month, 0, 11))];
    const SeasonalFoliage foliage = seasonal_foliage(web.species[std::size_t(kind.species)].plant(), month);
    // Many months look alike: their pictures stay.
    kind.pictured = kind.pictured && foliage.colour == kind.foliage.colour && foliage.bare == kind.foliage.bare;
    kind.foliage = foliage;
  }
  upload_kinds();
  take_pictures();
}

bool PlantKinds::set_visible(const SpeciesVisibility& visible) {
  if (visible == visible_) return false;
  visible_ = visible;
  upload_kinds();
  return true;
}

void PlantKinds::upload_kinds() {
  KindUniforms uniforms;
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const PlantKind& kind = kinds_[i];
    const auto number = std::size_t(kind.species);
    const float shown = number >= visible_.size() || visible_[number] ? 1.0F : 0.0F;
    // Half of the light comes through a bare crown.
    const float dense = 0.8F * (1 - 0.5F * kind.foliage.bare);
    uniforms.form[i] = {kind.extent.radius * shown, kind.extent.height, kind.shape.trunk_fraction, dense};
    uniforms.fresh[i] = glm::vec4(leaf_in_sward(kind, kind.foliage.fresh), kind.foliage.bare);
    uniforms.turned[i] = glm::vec4(leaf_in_sward(kind, kind.foliage.turned), kind.foliage.turn);
  }
  stream(uniforms_, std::span<const KindUniforms>(&uniforms, 1));
}

void PlantKinds::take_pictures() {
  const auto waits = [](const PlantKind& kind) { return kind.stratum != Stratum::herb && !kind.pictured; };
  if (std::none_of(kinds_.begin(), kinds_.end(), waits)) return;
  const DrawnElsewhere elsewhere(picture_side(), picture_side());
  const Framebuffer framebuffer = make_framebuffer();
  const Texture depth =
      make_texture_2d(GL_DEPTH_COMPONENT24, picture_side(), picture_side(), 1, {GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE});
  glNamedFramebufferTexture(framebuffer.name(), GL_DEPTH_ATTACHMENT, depth.name(), 0);
  constexpr std::array<GLenum, 2> targets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(framebuffer.name(), 2, targets.data());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name());
  glBindTextureUnit(leaves_unit, leaves_.name());
  bake_.use();
  bind_kinds();
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].stratum == Stratum::herb || kinds_[i].pictured) continue;
    kinds_[i].pictured = true;
    set_wood(bake_, kinds_[i]);
    const auto& leaf = kinds_[i].foliage.colour;
    bake_.set("leaf_colour", glm::vec3(leaf[0], leaf[1], leaf[2]));
    bake_.set("plant", int(i));
    for (int picture = 0; picture < plant_models * far_views; ++picture) {
      const GLint layer = GLint(i) * plant_models * far_views + picture;
      glNamedFramebufferTextureLayer(framebuffer.name(), GL_COLOR_ATTACHMENT0, far_pictures_.name(), 0, layer);
      glNamedFramebufferTextureLayer(framebuffer.name(), GL_COLOR_ATTACHMENT1, far_surfaces_.name(), 0, layer);
      constexpr std::array<float, 4> clear{0, 0, 0, 0};
      const float farthest = 1;
      glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, clear.data());
      glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 1, clear.data());
      glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &farthest);
      take_picture(kinds_[i], picture / far_views, elevations[std::size_t(picture % far_views)]);
    }
  }
  glGenerateTextureMipmap(far_pictures_.name());
  glGenerateTextureMipmap(far_surfaces_.name());
}

void PlantKinds::take_picture(const PlantKind& kind, int model, float elevation) const {
  const glm::vec3 toward(0, -std::cos(elevation), std::sin(elevation));
  const glm::vec3 right(1, 0, 0);
  const glm::vec3 up = glm::cross(toward, right);
  const float radius = kind.extent.radius;
  const float half_height = 0.5F * kind.extent.height * std::cos(elevation) + radius * std::sin(elevation);
  const glm::vec3 centre(0, 0, 0.5F * kind.extent.height);
  const float depth = 4 * (radius + kind.extent.height);
  bake_.set("projection", glm::ortho(-radius, radius, -half_height, half_height, 0.0F, depth) *
                              glm::lookAt(centre + toward * 0.5F * depth, centre, up));
  bake_.set("right", right);
  bake_.set("up", up);
  bake_.set("toward", toward);
  const PlantMeshBuffers& mesh = kind.near[std::size_t(model)];
  glBindVertexArray(mesh.array.name());
  glDrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_SHORT, nullptr);
}

void PlantKinds::bind() const {
  glBindTextureUnit(leaves_unit, leaves_.name());
  glBindTextureUnit(far_pictures_unit, far_pictures_.name());
  glBindTextureUnit(far_surfaces_unit, far_surfaces_.name());
  bind_kinds();
}

}  // namespace biotope
