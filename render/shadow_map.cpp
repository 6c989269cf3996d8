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
/// Sine of the lowest light that throws shadows.
constexpr float lowest_light = 0.075F;

/// `Shadows` of shaders/landscape/shadow.glsl.
struct ShadowUniforms {
  glm::vec4 right{0};                                 ///< w: 1 / ShadowView::reach
  glm::vec4 up{0};                                    ///< w: depth of the middle
  glm::vec4 toward{0};                                ///< w: strength
  std::array<glm::vec4, shadow_cascades> cascades{};  ///< centre, half side, softness
};

}  // namespace

ShadowView shadow_view(const Camera& camera, double above, const glm::vec3& light, float strength) {
  ShadowView view;
  view.strength = strength;
  view.toward = glm::normalize(glm::vec3(light.x, light.y, std::max(light.z, lowest_light)));
  // Turns with the light alone.
  const glm::vec3 level =
      std::abs(view.toward.z) > 0.999F ? glm::vec3(1, 0, 0) : glm::normalize(glm::vec3(-view.toward.y, view.toward.x, 0));
  view.right = level;
  view.up = glm::cross(view.toward, level);
  const auto growth = float(std::clamp(std::sqrt(above / growing_height), 1.0, largest));
  const glm::dvec3 ground = camera.position - glm::dvec3(0, 0, above);
  const glm::vec2 ahead(camera.forward());
  view.centre_depth = -float(above) * view.toward.z;
  view.reach = 400 + 2.5F * half_sides.back() * growth;
  for (int i = 0; i < shadow_cascades; ++i) {
    ShadowCascade& cascade = view.cascades[std::size_t(i)];
    cascade.half_side = half_sides[std::size_t(i)] * growth;
    cascade.softness = softness[std::size_t(i)] * growth;
    const glm::dvec3 middle = ground + glm::dvec3(glm::dvec2(ahead) * double(0.7F * cascade.half_side), 0);
    const double texel = 2.0 * double(cascade.half_side) / shadow_texels;
    const auto along = [&](const glm::vec3& axis) {
      const glm::dvec3 exact(axis);
      return float(std::round(glm::dot(exact, middle) / texel) * texel - glm::dot(exact, camera.position));
    };
    cascade.centre = {along(view.right), along(view.up)};
  }
  return view;
}

bool casts_into(const ShadowView& view, int cascade, const glm::vec3& centre, float radius) {
  const ShadowCascade& square = view.cascades[std::size_t(cascade)];
  const glm::vec2 at(glm::dot(view.right, centre), glm::dot(view.up, centre));
  const glm::vec2 away = glm::abs(at - square.centre);
  return std::max(away.x, away.y) < square.half_side + radius;
}

void ShadowMap::begin(const ShadowView& view) {
  if (!depth_) {
    depth_ = make_texture_array(GL_DEPTH_COMPONENT24, shadow_texels, shadow_texels, shadow_cascades, 1,
                                {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
    glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    for (int i = 0; i < shadow_cascades; ++i) {
      Framebuffer& framebuffer = framebuffers_[std::size_t(i)];
      framebuffer = make_framebuffer();
      glNamedFramebufferTextureLayer(framebuffer.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0, i);
      glNamedFramebufferDrawBuffer(framebuffer.name(), GL_NONE);
    }
    uniforms_ = make_buffer();
  }
  ShadowUniforms uniforms;
  uniforms.right = glm::vec4(view.right, 1 / view.reach);
  uniforms.up = glm::vec4(view.up, view.centre_depth);
  uniforms.toward = glm::vec4(view.toward, view.strength);
  for (std::size_t i = 0; i < shadow_cascades; ++i) {
    const ShadowCascade& cascade = view.cascades[i];
    uniforms.cascades[i] = {cascade.centre, cascade.half_side, cascade.softness};
  }
  stream(uniforms_, std::span<const ShadowUniforms>(&uniforms, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, uniforms_.name());
  glBindTextureUnit(unit, depth_.name());
}

void ShadowMap::open(int cascade) const {
  const Framebuffer& framebuffer = framebuffers_[std::size_t(cascade)];
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name());
  const float farthest = 1;
  glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &farthest);
  // What stands nearer to the light than the picture reaches still throws its shadow.
  glEnable(GL_DEPTH_CLAMP);
}

void ShadowMap::end() const { glDisable(GL_DEPTH_CLAMP); }

}  // namespace biotope
