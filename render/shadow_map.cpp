#include "render/shadow_map.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Sides of the squares for an eye near the ground, m.
constexpr std::array<float, shadow_cascades> half_sides{34, 140, 560};
/// The sun is half a degree wide: what is some metres above the ground has an edge that soft (our choice, and a texel at least).
constexpr std::array<float, shadow_cascades> softness{0.055F, 0.16F, 0.55F};
/// From this height over the ground on squares grow, as one sees more ground.
constexpr double growing_height = 14;
constexpr double largest = 5;
/// Squares grow by this factor at a time.
constexpr double growth_step = 1.414213562373095;
/// Sine of the lowest light that throws shadows.
constexpr float lowest_light = 0.075F;
/// The light moves in steps of this many degrees: the top of a tree's shadow of 20 m by less than 2 cm.
constexpr double light_step = 0.05;
/// A square moves by this part of half its side, which is a whole number of texels; the middle of its depth too.
constexpr double cell_part = 0.25;
static_assert(int(cell_part * shadow_texels) % 2 == 0);

/// `Shadows` of shaders/landscape/shadow.glsl.
struct ShadowUniforms {
  std::array<glm::vec4, shadow_cascades> right{};     ///< w: 1 / ShadowLight::reach
  std::array<glm::vec4, shadow_cascades> up{};        ///< w: ShadowCascade::depth
  std::array<glm::vec4, shadow_cascades> toward{};    ///< w: strength
  std::array<glm::vec4, shadow_cascades> cascades{};  ///< centre, half side, softness
};

/// A direction in steps of light_step.
glm::vec3 stepped(const glm::vec3& light) {
  const double step = glm::radians(light_step);
  const double height = std::round(std::asin(std::clamp(double(light.z), -1.0, 1.0)) / step) * step;
  const double way = std::round(std::atan2(double(light.y), double(light.x)) / step) * step;
  return glm::vec3(glm::dvec3(std::cos(height) * std::cos(way), std::cos(height) * std::sin(way), std::sin(height)));
}

/// Lays a square whose middle should be at a place of the land on its lattice.
ShadowCascade laid(ShadowCascade cascade, const glm::dvec3& middle, const glm::dvec3& eye) {
  const ShadowLight& light = cascade.light;
  const double cell = cell_part * double(cascade.half_side);
  const glm::dvec3 at = glm::round(light.of(middle) / cell) * cell;
  const glm::dvec3 origin =
      glm::round(glm::dvec3(light.right) * at.x + glm::dvec3(light.up) * at.y + glm::dvec3(light.toward) * at.z);
  cascade.origin = glm::vec3(origin);
  cascade.from_origin = glm::vec3(at - light.of(origin));
  return seen_from(cascade, eye);
}

}  // namespace

ShadowView shadow_view(const Camera& camera, double above, const glm::vec3& light, float strength) {
  ShadowView view;
  view.strength = strength;
  ShadowLight of;
  of.toward = stepped(glm::normalize(glm::vec3(light.x, light.y, std::max(light.z, lowest_light))));
  // Turns with the light alone.
  of.right = std::abs(of.toward.z) > 0.999F ? glm::vec3(1, 0, 0) : glm::normalize(glm::vec3(-of.toward.y, of.toward.x, 0));
  of.up = glm::cross(of.toward, of.right);
  const double wanted = std::clamp(std::sqrt(above / growing_height), 1.0, largest);
  const auto growth = float(std::pow(growth_step, std::round(std::log(wanted) / std::log(growth_step))));
  const glm::dvec3 ground = camera.position - glm::dvec3(0, 0, above);
  const glm::dvec2 ahead(camera.forward());
  of.reach = 400 + 2.5F * half_sides.back() * growth;
  for (std::size_t i = 0; i < shadow_cascades; ++i) {
    ShadowCascade& cascade = view.cascades[i];
    cascade.light = of;
    cascade.half_side = half_sides[i] * growth;
    cascade.softness = softness[i] * growth;
    cascade = laid(cascade, ground + glm::dvec3(ahead * (0.7 * double(cascade.half_side)), 0), camera.position);
  }
  return view;
}

ShadowCascade seen_from(ShadowCascade cascade, const glm::dvec3& eye) {
  const glm::dvec3 from_eye = cascade.light.of(glm::dvec3(cascade.origin) - eye) + glm::dvec3(cascade.from_origin);
  cascade.centre = glm::vec2(from_eye);
  cascade.depth = float(from_eye.z);
  return cascade;
}

bool casts_into(const ShadowView& view, int cascade, const glm::vec3& centre, float radius) {
  const ShadowCascade& square = view.cascades[std::size_t(cascade)];
  const glm::vec2 at(glm::dot(square.light.right, centre), glm::dot(square.light.up, centre));
  const glm::vec2 away = glm::abs(at - square.centre);
  return std::max(away.x, away.y) < square.half_side + radius;
}

bool throws_into(const ShadowView& view, int cascade, const glm::dvec3& centre, float radius) {
  const ShadowCascade& square = view.cascades[std::size_t(cascade)];
  const glm::vec3 from_origin(centre - glm::dvec3(square.origin));
  const glm::vec2 at(glm::dot(square.light.right, from_origin), glm::dot(square.light.up, from_origin));
  const glm::vec2 away = glm::abs(at - glm::vec2(square.from_origin));
  return std::max(away.x, away.y) < square.half_side + radius;
}

void ShadowMap::begin(const ShadowView& view) {
  if (!depth_) {
    const auto make = [](Texture& texture, std::array<Framebuffer, shadow_cascades>& framebuffers) {
      texture = make_texture_array(GL_DEPTH_COMPONENT24, shadow_texels, shadow_texels, shadow_cascades, 1,
                                   {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
      for (int i = 0; i < shadow_cascades; ++i) {
        Framebuffer& framebuffer = framebuffers[std::size_t(i)];
        framebuffer = make_framebuffer();
        glNamedFramebufferTextureLayer(framebuffer.name(), GL_DEPTH_ATTACHMENT, texture.name(), 0, i);
        glNamedFramebufferDrawBuffer(framebuffer.name(), GL_NONE);
      }
    };
    make(standing_, standing_framebuffers_);
    make(depth_, framebuffers_);
    glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    uniforms_ = make_buffer();
  }
  cascades_ = view.cascades;
  ShadowUniforms uniforms;
  for (std::size_t i = 0; i < shadow_cascades; ++i) {
    const ShadowCascade& cascade = view.cascades[i];
    uniforms.right[i] = glm::vec4(cascade.light.right, 1 / cascade.light.reach);
    uniforms.up[i] = glm::vec4(cascade.light.up, cascade.depth);
    uniforms.toward[i] = glm::vec4(cascade.light.toward, view.strength);
    uniforms.cascades[i] = {cascade.centre, cascade.half_side, cascade.softness};
  }
  stream(uniforms_, std::span<const ShadowUniforms>(&uniforms, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, uniforms_.name());
  glBindTextureUnit(unit, depth_.name());
  // What stands nearer to the light than the picture reaches still throws its shadow.
  glEnable(GL_DEPTH_CLAMP);
}

void ShadowMap::open_standing(int cascade) const {
  const Framebuffer& framebuffer = standing_framebuffers_[std::size_t(cascade)];
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name());
  const float farthest = 1;
  glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &farthest);
}

ShadowMap::Texels ShadowMap::texels_of(const ShadowCascade& cascade, const ShadowBox& box) const {
  if (box.empty()) return {};
  const auto texel = [&](const glm::vec2& at) {
    return ((at - cascade.centre) / cascade.half_side * 0.5F + 0.5F) * float(shadow_texels);
  };
  const glm::vec2 most(shadow_texels);
  const glm::ivec2 first(glm::clamp(glm::floor(texel(box.low)) - 1.0F, glm::vec2(0), most));
  const glm::ivec2 last(glm::clamp(glm::ceil(texel(box.high)) + 1.0F, glm::vec2(0), most));
  return {first, last - first};
}

void ShadowMap::copy(int cascade, const Texels& texels) const {
  if (texels.count.x <= 0 || texels.count.y <= 0) return;
  glCopyImageSubData(standing_.name(), GL_TEXTURE_2D_ARRAY, 0, texels.first.x, texels.first.y, cascade, depth_.name(),
                     GL_TEXTURE_2D_ARRAY, 0, texels.first.x, texels.first.y, cascade, texels.count.x, texels.count.y, 1);
}

void ShadowMap::open_moving(int cascade, bool anew, const ShadowBox& box) {
  Texels& moved = moved_[std::size_t(cascade)];
  copy(cascade, anew ? Texels{glm::ivec2(0), glm::ivec2(shadow_texels)} : moved);
  moved = texels_of(cascades_[std::size_t(cascade)], box);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[std::size_t(cascade)].name());
  // Nothing is left outside of what the next frame copies.
  glScissor(moved.first.x, moved.first.y, moved.count.x, moved.count.y);
  glEnable(GL_SCISSOR_TEST);
}

void ShadowMap::end() const {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_CLAMP);
}

}  // namespace biotope
