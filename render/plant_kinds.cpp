#include "render/plant_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "render/plant_leaves.hpp"
#include "render/plant_undergrowth.hpp"

namespace biotope {

namespace {

constexpr int far_views = 3;
/// Heights from which the far pictures are taken (radians above the horizon); the same as in plant_far.vert.
constexpr std::array<float, far_views> elevations{0.17453F, 0.78540F, 1.30900F};

glm::vec3 linear(const std::array<float, 3>& srgb) {
  const auto c = linear_colour(srgb);
  return {c[0], c[1], c[2]};
}

/// Bark, our choice: white for birch, reddish for pines, dark for alders, silvery where it is smooth, else grey-brown.
glm::vec3 wood_colour(const PlantShape& shape) {
  const std::string& model = shape.model;
  if (model == "birch") return linear({0.84F, 0.83F, 0.79F});
  if (model == "conifer" || model == "mountain-pine") return linear({0.47F, 0.39F, 0.33F});
  if (model == "alder") return linear({0.44F, 0.41F, 0.37F});
  if (model == "juniper") return linear({0.50F, 0.41F, 0.34F});
  if (model == "evergreen-oak") return linear({0.42F, 0.39F, 0.35F});
  const bool smooth = model == "broadleaf" && (shape.trunk_fraction < 0.12F || shape.crown_diameter < 0.68F * shape.height);
  return smooth ? linear({0.46F, 0.45F, 0.42F}) : linear({0.49F, 0.45F, 0.40F});
}

/// Bark of the upper half: Scots pines and their like are orange there.
glm::vec3 high_wood_colour(const PlantShape& shape) {
  if (shape.model == "conifer" && shape.trunk_fraction > 0.25F) return linear({0.64F, 0.42F, 0.27F});
  return wood_colour(shape);
}

/// Barks go around a trunk again and again; leaves are clear at their pictures' edges.
Texture leaf_texture() {
  const std::vector<Grid<Rgba>> pictures = leaf_pictures();
  Texture texture = make_texture_array(GL_RGBA8, leaf_picture_side, leaf_picture_side, int(pictures.size()), 7,
                                       {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::vector<Grid<Rgba>> levels = leaf_mipmaps(LeafPicture(i), pictures[i]);
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
  std::array<glm::vec4, 256> form{};
  std::array<glm::vec4, 256> fresh{};
  std::array<glm::vec4, 256> turned{};
};

/// Meadows flower from April to August, one kind after the other (our choice).
float share_in_flower(int species, int month) {
  constexpr std::array<float, 4> peaks{4.3F, 5.1F, 5.8F, 6.7F};
  const float off = (float(month) - peaks[std::size_t(species) % peaks.size()]) / 1.35F;
  return 0.44F * std::exp(-off * off);
}

glm::vec3 leaf_in_sward(const PlantKind& kind, const std::array<float, 3>& colour) {
  const auto c = kind.stratum == Stratum::herb ? meadow_colour(colour) : colour;
  return {c[0], c[1], c[2]};
}

}  // namespace

PlantMeshBuffers upload(const OrderedMesh& mesh) {
  PlantMeshBuffers out;
  out.vertices = make_static_buffer(std::as_bytes(std::span(mesh.vertices)));
  out.indices = make_static_buffer(std::as_bytes(std::span(mesh.indices)));
  out.array = make_vertex_array();
  out.index_count = GLsizei(mesh.index_count);
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
  program.set("wood_colour", kind.wood);
  program.set("high_wood_colour", kind.high_wood);
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
  kinds.make_undergrowth();
  return kinds;
}

void PlantKinds::take(std::shared_ptr<const PlantModels> models) {
  coming_ = std::move(models);
  coming_kinds_.clear();
}

bool PlantKinds::upload(UploadBudget& budget) {
  if (!coming_) return true;
  const std::size_t count = coming_->meshes.size() / plant_models;
  while (coming_kinds_.size() < count) {
    if (budget.spent()) return false;
    upload_kind(coming_kinds_.size());
    for (std::size_t model = 0; model < plant_models; ++model) {
      const ModelMeshes& meshes = coming_->meshes[plant_models * (coming_kinds_.size() - 1) + model];
      budget.take(meshes.close.bytes() + meshes.near.bytes() + meshes.mid.bytes());
    }
  }
  kinds_ = std::exchange(coming_kinds_, {});
  coming_ = nullptr;
  month_ = -1;
  make_far_pictures();
  return true;
}

void PlantKinds::upload_kind(std::size_t kind) {
  const FoodWeb& web = *coming_->web;
  const PlantTraits& traits = web.species[std::size_t(web.levels[0][kind])].plant();
  PlantKind made;
  made.species = web.levels[0][kind];
  made.stratum = traits.stratum;
  made.shape = traits.shape;
  made.wood = wood_colour(made.shape);
  made.high_wood = high_wood_colour(made.shape);
  for (std::size_t model = 0; model < plant_models; ++model) {
    const ModelMeshes& meshes = coming_->meshes[plant_models * kind + model];
    const PlantExtent& extent = meshes.near.extent;
    made.extent = {std::max(made.extent.radius, extent.radius), std::max(made.extent.height, extent.height)};
    if (meshes.close.index_count > 0) made.close[model] = biotope::upload(meshes.close);
    made.near[model] = biotope::upload(meshes.near);
    made.mid[model] = biotope::upload(meshes.mid);
  }
  coming_kinds_.push_back(std::move(made));
}

void PlantKinds::make_far_pictures() {
  const auto layers = int(std::max<std::size_t>(1, kinds_.size())) * plant_models * far_views;
  const Sampling smooth{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE};
  // Mipmaps down to 4 texels: below that a plant is a dot, and species must not run into each other.
  far_pictures_ = make_texture_array(GL_RGBA8, picture_side(), picture_side(), layers, 6, smooth);
  far_surfaces_ = make_texture_array(GL_RGBA8, picture_side(), picture_side(), layers, 6, smooth);
}

void PlantKinds::make_undergrowth() {
  for (int i = 0; i < undergrowth_kinds; ++i) {
    const UndergrowthLook look = undergrowth_look(Undergrowth(i));
    const PlantMesh mesh = undergrowth_mesh(Undergrowth(i), 0x666c6f6f72ULL + std::uint64_t(i));
    PlantKind kind;
    kind.species = -1;
    kind.shape = look.traits.shape;
    kind.wood = kind.high_wood = linear(look.wood);
    kind.extent = extent_of(mesh);
    kind.near.front() = biotope::upload(ordered(mesh));
    undergrowth_.push_back(std::move(kind));
  }
}

void PlantKinds::set_month(const FoodWeb& web, int month) {
  if (month == month_ || kinds_.empty()) return;
  month_ = month;
  for (PlantKind& kind : kinds_) {
    kind.bloom = share_in_flower(kind.species, month);
    const SeasonalFoliage foliage = seasonal_foliage(web.species[std::size_t(kind.species)].plant(), month);
    // Many months look alike: their pictures stay.
    kind.pictured = kind.pictured && foliage.colour == kind.foliage.colour && foliage.bare == kind.foliage.bare;
    kind.foliage = foliage;
  }
  for (std::size_t i = 0; i < undergrowth_.size(); ++i) {
    // Ferns and herbs of the shade wither a month before the meadows.
    const UndergrowthLook look = undergrowth_look(Undergrowth(i));
    const bool withers = look.traits.stratum == Stratum::herb && month >= 8 && month < 11;
    undergrowth_[i].foliage = seasonal_foliage(look.traits, withers ? month + 1 : month);
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
    const float dense = 0.88F * (1 - 0.5F * kind.foliage.bare);
    uniforms.form[i] = {kind.extent.radius * shown, kind.extent.height, kind.shape.trunk_fraction, dense};
    uniforms.fresh[i] = glm::vec4(leaf_in_sward(kind, kind.foliage.fresh), kind.foliage.bare);
    uniforms.turned[i] = glm::vec4(leaf_in_sward(kind, kind.foliage.turned), kind.foliage.turn);
  }
  for (std::size_t i = 0; i < undergrowth_.size(); ++i) {
    const PlantKind& kind = undergrowth_[i];
    const std::size_t slot = std::size_t(first_undergrowth_kind) + i;
    const auto colour = [](const std::array<float, 3>& c) { return glm::vec3(c[0], c[1], c[2]); };
    uniforms.form[slot] = {kind.extent.radius, kind.extent.height, 0, 0};
    uniforms.fresh[slot] = glm::vec4(colour(kind.foliage.fresh), kind.foliage.bare);
    uniforms.turned[slot] = glm::vec4(colour(kind.foliage.turned), kind.foliage.turn);
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

void PlantKinds::set_quality(float quality) const {
  constexpr float medium = 0.75F;
  for (const Texture* texture : {&leaves_, &far_pictures_, &far_surfaces_}) {
    if (*texture) mix_mipmaps(texture->name(), quality >= medium);
  }
}

void PlantKinds::bind() const {
  glBindTextureUnit(leaves_unit, leaves_.name());
  glBindTextureUnit(far_pictures_unit, far_pictures_.name());
  glBindTextureUnit(far_surfaces_unit, far_surfaces_.name());
  bind_kinds();
}

}  // namespace biotope
