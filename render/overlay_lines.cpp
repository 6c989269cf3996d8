#include "render/overlay_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace biotope {
namespace {

constexpr float most_mitre = 2;  // times half the width: sharper corners are cut
constexpr float feathered = 1;   // pixels a ribbon is wider on either side than its line, for smooth edges

/// A point of a line on the screen.
struct Seen {
  glm::vec2 pixel{0};
  float nearness = 0;
  float along = 0;
};

/// Brings places onto the screen.
class Projection {
 public:
  Projection(const Camera& camera, const glm::vec2& size)
      : eye_(camera.position),
        forward_(camera.forward()),
        right_(camera.right()),
        up_(glm::cross(right_, forward_)),
        size_(size),
        pixels_(0.5 * double(size.y) / std::tan(0.5 * glm::radians(double(camera.vertical_field)))) {}
  [[nodiscard]] double depth(const glm::dvec3& place) const { return glm::dot(place - eye_, forward_); }
  [[nodiscard]] Seen seen(const glm::dvec3& place) const {
    const glm::dvec3 from_eye = place - eye_;
    const double nearness = 1 / glm::dot(from_eye, forward_);
    return {{float(0.5 * double(size_.x) + glm::dot(from_eye, right_) * nearness * pixels_),
             float(0.5 * double(size_.y) - glm::dot(from_eye, up_) * nearness * pixels_)},
            float(nearness)};
  }

 private:
  glm::dvec3 eye_, forward_, right_, up_;
  glm::vec2 size_;
  double pixels_;
};

/// From the middle to the left edge of a ribbon at a point between two others, in units of half its width.
glm::vec2 to_edge(const Seen* before, const Seen& at, const Seen* after) {
  const auto normal = [](const Seen& from, const Seen& to) {
    const glm::vec2 way = to.pixel - from.pixel;
    return glm::vec2(-way.y, way.x) / std::max(glm::length(way), 1e-6F);
  };
  if (before == nullptr) return normal(at, *after);
  if (after == nullptr) return normal(*before, at);
  const glm::vec2 first = normal(*before, at);
  const glm::vec2 sum = first + normal(at, *after);
  const float length = glm::length(sum);
  if (length < 1e-3F) return first;
  const glm::vec2 middle = sum / length;
  return middle * std::min(1 / std::max(glm::dot(middle, first), 1e-3F), most_mitre);
}

void add_piece(const OverlayLine& line, std::vector<Seen>& piece, std::vector<OverlayVertex>& out) {
  // Points that fall together have no direction.
  const auto same = [](const Seen& a, const Seen& b) { return glm::length(a.pixel - b.pixel) < 0.05F; };
  piece.erase(std::unique(piece.begin(), piece.end(), same), piece.end());
  for (std::size_t i = 1; i < piece.size(); ++i)
    piece[i].along = piece[i - 1].along + glm::length(piece[i].pixel - piece[i - 1].pixel);
  const float half = 0.5F * line.width;
  const float reach = half + line.casing_width + feathered;
  const auto corner = [&](std::size_t i, float side) {
    const glm::vec2 edge = to_edge(i > 0 ? &piece[i - 1] : nullptr, piece[i], i + 1 < piece.size() ? &piece[i + 1] : nullptr);
    return OverlayVertex{piece[i].pixel + edge * (side * reach),
                         piece[i].nearness,
                         side * reach,
                         piece[i].along,
                         half,
                         half + line.casing_width,
                         line.dash,
                         line.colour,
                         line.casing};
  };
  for (std::size_t i = 1; i < piece.size(); ++i) {
    const OverlayVertex a = corner(i - 1, -1);
    const OverlayVertex b = corner(i - 1, 1);
    const OverlayVertex c = corner(i, -1);
    const OverlayVertex d = corner(i, 1);
    out.insert(out.end(), {a, b, c, c, b, d});
  }
  piece.clear();
}

}  // namespace

void add_ribbon(const OverlayLine& line, const Camera& camera, const glm::vec2& size, float nearest,
                std::vector<OverlayVertex>& out) {
  const Projection projection(camera, size);
  std::vector<Seen> piece;
  std::optional<double> last;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const glm::dvec3& at = line.points[i];
    const double depth = projection.depth(at) - double(nearest);
    if (last && (*last >= 0) != (depth >= 0)) {
      // It passes the plane in front of the eye: cut there.
      const glm::dvec3& before = line.points[i - 1];
      const Seen cut = projection.seen(before + (at - before) * (*last / (*last - depth)));
      piece.push_back(cut);
      if (depth < 0) add_piece(line, piece, out);
    }
    if (depth >= 0) piece.push_back(projection.seen(at));
    last = depth;
  }
  add_piece(line, piece, out);
}

Result<OverlayLines> OverlayLines::create() {
  OverlayLines lines;
  auto program = load_shader_program("landscape/overlay_line.vert", "landscape/overlay_line.frag");
  if (!program) return tl::unexpected(program.error());
  lines.program_ = std::move(*program);
  lines.vertex_array_ = make_vertex_array();
  lines.buffer_ = make_buffer();
  const VertexArray& array = lines.vertex_array_;
  glVertexArrayVertexBuffer(array.name(), 0, lines.buffer_.name(), 0, sizeof(OverlayVertex));
  float_attribute(array, 0, 0, 2, offsetof(OverlayVertex, pixel));
  float_attribute(array, 1, 0, 3, offsetof(OverlayVertex, nearness));
  float_attribute(array, 2, 0, 3, offsetof(OverlayVertex, half_width));
  float_attribute(array, 3, 0, 4, offsetof(OverlayVertex, colour));
  float_attribute(array, 4, 0, 4, offsetof(OverlayVertex, casing));
  return lines;
}

void OverlayLines::draw(std::span<const OverlayVertex> vertices, const DepthPicture& depth, const glm::vec2& size) const {
  if (vertices.empty()) return;
  stream(buffer_, vertices);
  program_.use();
  program_.set("size", size);
  program_.set("planes", glm::vec2(1 / depth.near_plane, 1 / depth.far_plane));
  glBindTextureUnit(0, depth.texture);
  glBindSampler(0, 0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(vertex_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
  glBindVertexArray(0);
}

}  // namespace biotope
