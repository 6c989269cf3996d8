#include "render/plant_mesh_order.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace biotope {

namespace {

constexpr float turn_of_order = glm::two_pi<float>() / float(mesh_orders);
/// Where the eye is thought to be: so many heights of the plant away, at this share of its height (our choice).
constexpr float eye_away = 1.2F;
constexpr float eye_up = 0.2F;

/// Triangles that follow each other and share an edge: a card of foliage, a piece of a stem. They stay together, so that no
/// vertex is shaded twice.
struct Piece {
  std::size_t first = 0;  ///< in the mesh's indices
  std::size_t count = 0;
  glm::vec3 middle{0};
};
constexpr std::size_t most_in_piece = 12;

bool shares_edge(const PlantMesh& mesh, std::size_t a, std::size_t b) {
  int shared = 0;
  for (std::size_t i = a; i < a + 3; ++i) {
    for (std::size_t j = b; j < b + 3; ++j) shared += mesh.indices[i] == mesh.indices[j] ? 1 : 0;
  }
  return shared >= 2;
}

std::vector<Piece> pieces_of(const PlantMesh& mesh) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (pieces.empty() || pieces.back().count >= most_in_piece || !shares_edge(mesh, i - 3, i)) pieces.push_back({i, 0, {}});
    for (std::size_t c = i; c < i + 3; ++c) pieces.back().middle += mesh.vertices[mesh.indices[c]].position;
    pieces.back().count += 3;
  }
  for (Piece& piece : pieces) piece.middle /= float(piece.count);
  return pieces;
}

}  // namespace

std::vector<std::uint16_t> ordered_indices(const PlantMesh& mesh) {
  const std::vector<Piece> pieces = pieces_of(mesh);
  const PlantExtent extent = extent_of(mesh);
  const float away = extent.radius + eye_away * extent.height;
  std::vector<std::uint16_t> out;
  out.reserve(mesh_orders * mesh.indices.size());
  for (int order = 0; order < mesh_orders; ++order) {
    const float turn = turn_of_order * float(order);
    const glm::vec3 eye(away * std::cos(turn), away * std::sin(turn), eye_up * extent.height);
    std::vector<std::pair<float, std::size_t>> by_distance(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) by_distance[i] = {glm::distance(pieces[i].middle, eye), i};
    std::sort(by_distance.begin(), by_distance.end());
    for (const auto& [distance, i] : by_distance) {
      const auto first = mesh.indices.begin() + std::ptrdiff_t(pieces[i].first);
      out.insert(out.end(), first, first + std::ptrdiff_t(pieces[i].count));
    }
  }
  return out;
}

int mesh_order(const PlantInstance& plant, const glm::vec3& eye) {
  const float toward = std::atan2(eye.y - plant.y, eye.x - plant.x) - plant.turn;
  const int nearest = int(std::lround(toward / turn_of_order));
  return ((nearest % mesh_orders) + mesh_orders) % mesh_orders;
}

}  // namespace biotope
