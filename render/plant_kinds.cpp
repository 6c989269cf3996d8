#include "render/plant_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/plant_leaves.hpp"
#include "render/plant_placement.hpp"

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
  if (model == "birch") return linear({0.78F, 0.77F, 0.73F});
  if (model == "conifer" || model == "mountain-pine") return linear({0.44F, 0.33F, 0.26F});
  if (model == "alder") return linear({0.36F, 0.33F, 0.29F});
  return linear({0.40F, 0.35F, 0.30F});
}

Texture leaf_texture() {
  const std::vector<Grid<Rgba>> pictures = leaf_pictures();
  Texture texture = make_texture_array(GL_RGBA8, leaf_picture_side, leaf_picture_side, int(pictures.size()), 0,
                                       {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    // Premultiplied, so that mipmaps do not draw in the colour of what is clear.
    Grid<Rgba> texels = pictures[i];
    for (Rgba& texel : texels.cells()) {
      if (texel[3] == 0) texel = {0, 0, 0, 0};
    }
    glTextureSubImage3D(texture.name(), 0, 0, 0, GLint(i), leaf_picture_side, leaf_picture_side, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.cells().data());
  }
  glGenerateTextureMipmap(texture.name());
  return texture;
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

void set_colours(const ShaderProgram& program, const PlantKind& kind) {
  const auto leaf = kind.stratum == Stratum::herb ? meadow_colour(kind.foliage.colour) : kind.foliage.colour;
  program.set("leaf_colour", glm::vec3(leaf[0], leaf[1], leaf[2]));
  program.set("wood_colour", wood_colour(kind.shape.model));
  program.set("flower_colour", linear(kind.shape.flower_colour));
  program.set("bare", kind.foliage.bare);
  program.set("bloom", kind.bloom);
}

Result<PlantKinds> PlantKinds::create() {
  auto bake = load_shader_program("landscape/plant_bake.vert", "landscape/plant_bake.frag");
  if (!bake) return tl::unexpected(bake.error());
  PlantKinds kinds;
  kinds.bake_ = std::move(*bake);
  kinds.leaves_ = leaf_texture();
  kinds.extents_ = make_buffer();
  return kinds;
}

void PlantKinds::set_web(const FoodWeb& web) {
  kinds_.clear();
  month_ = -1;
  if (web.levels.empty()) return;
  std::vector<glm::vec4> extents(most_plant_kinds, glm::vec4(1));
  for (std::size_t i = 0; i < web.levels[0].size() && i < most_plant_kinds; ++i) {
    PlantKind kind;
    kind.species = web.levels[0][i];
    const PlantTraits& plant = web.species[std::size_t(kind.species)].plant();
    kind.stratum = plant.stratum;
    kind.shape = plant.shape;
    const std::uint64_t seed = 0x6b696e64ULL + i;
    const PlantMesh near = make_plant_mesh(plant.shape, PlantDetail::near, seed);
    kind.extent = extent_of(near);
    kind.near = upload(near);
    kind.mid = upload(make_plant_mesh(plant.shape, PlantDetail::mid, seed));
    extents[i] = {kind.extent.radius, kind.extent.height, plant.shape.trunk_fraction, 0.8F};
    kinds_.push_back(std::move(kind));
  }
  stream(extents_, std::span<const glm::vec4>(extents));
  const auto layers = int(std::max<std::size_t>(1, kinds_.size())) * far_views;
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
    kind.foliage = seasonal_foliage(web.species[std::size_t(kind.species)].plant(), month);
  }
  take_pictures();
}

void PlantKinds::take_pictures() {
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
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].stratum == Stratum::herb) continue;
    set_colours(bake_, kinds_[i]);
    for (int view = 0; view < far_views; ++view) {
      const GLint layer = GLint(i) * far_views + view;
      glNamedFramebufferTextureLayer(framebuffer.name(), GL_COLOR_ATTACHMENT0, far_pictures_.name(), 0, layer);
      glNamedFramebufferTextureLayer(framebuffer.name(), GL_COLOR_ATTACHMENT1, far_surfaces_.name(), 0, layer);
      constexpr std::array<float, 4> clear{0, 0, 0, 0};
      const float farthest = 1;
      glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, clear.data());
      glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 1, clear.data());
      glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &farthest);
      take_picture(kinds_[i], elevations[std::size_t(view)]);
    }
  }
  glGenerateTextureMipmap(far_pictures_.name());
  glGenerateTextureMipmap(far_surfaces_.name());
}

void PlantKinds::take_picture(const PlantKind& kind, float elevation) const {
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
  glBindVertexArray(kind.near.array.name());
  glDrawElements(GL_TRIANGLES, kind.near.index_count, GL_UNSIGNED_SHORT, nullptr);
}

void PlantKinds::bind() const {
  glBindTextureUnit(leaves_unit, leaves_.name());
  glBindTextureUnit(far_pictures_unit, far_pictures_.name());
  glBindTextureUnit(far_surfaces_unit, far_surfaces_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, extents_binding, extents_.name());
}

}  // namespace biotope
