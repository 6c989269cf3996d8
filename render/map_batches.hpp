#pragma once

#include <span>

#include "render/gl_objects.hpp"
#include "render/map_lines.hpp"

namespace biotope {

/// Bands on the graphics card.
struct RibbonBatch {
  Buffer vertices = make_buffer();
  Buffer indices = make_buffer();
  VertexArray array = make_vertex_array();
  GLsizei count = 0;

  RibbonBatch() {
    glVertexArrayVertexBuffer(array.name(), 0, vertices.name(), 0, sizeof(RibbonVertex));
    glVertexArrayElementBuffer(array.name(), indices.name());
    float_attribute(array, 0, 0, 2, offsetof(RibbonVertex, x));
    float_attribute(array, 1, 0, 2, offsetof(RibbonVertex, normal_x));
    float_attribute(array, 2, 0, 1, offsetof(RibbonVertex, side));
    float_attribute(array, 3, 0, 1, offsetof(RibbonVertex, strength));
    float_attribute(array, 4, 0, 1, offsetof(RibbonVertex, metres));
    glEnableVertexArrayAttrib(array.name(), 5);
    glVertexArrayAttribFormat(array.name(), 5, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(RibbonVertex, tone));
    glVertexArrayAttribBinding(array.name(), 5, 0);
  }
  void upload(const RibbonMesh& mesh) {
    stream(vertices, std::span<const RibbonVertex>(mesh.vertices));
    stream(indices, std::span<const std::uint32_t>(mesh.indices));
    count = GLsizei(mesh.indices.size());
  }
  void draw() const {
    if (count == 0) return;
    glBindVertexArray(array.name());
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  }
};

/// Herds' marks, one instance each.
struct MarkerBatch {
  Buffer instances = make_buffer();
  VertexArray array = make_vertex_array();

  MarkerBatch() {
    glVertexArrayVertexBuffer(array.name(), 0, instances.name(), 0, sizeof(HerdMarker));
    glVertexArrayBindingDivisor(array.name(), 0, 1);
    float_attribute(array, 0, 0, 2, offsetof(HerdMarker, x));
    float_attribute(array, 1, 0, 1, offsetof(HerdMarker, heading));
    float_attribute(array, 2, 0, 1, offsetof(HerdMarker, pixels));
    glEnableVertexArrayAttrib(array.name(), 3);
    glVertexArrayAttribFormat(array.name(), 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(HerdMarker, tone));
    glVertexArrayAttribBinding(array.name(), 3, 0);
  }
  void draw(std::span<const HerdMarker> markers) const {
    if (markers.empty()) return;
    stream(instances, markers);
    glBindVertexArray(array.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(markers.size()));
  }
};

}  // namespace biotope
