#include "ui/view_pen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace biotope {
namespace {

constexpr float dash_length = 7;  // at scale 1
constexpr float hidden_alpha = 0.4F;

/// Draws dashes of a piece, of which `carried` pixels came before; returns what the next piece begins with.
float draw_dashes(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 colour, float width, float dash, float carried) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  if (length <= 0) return carried;
  const ImVec2 step((b.x - a.x) / length, (b.y - a.y) / length);
  for (float at = -carried; at < length; at += 2 * dash) {
    const float from = std::max(at, 0.0F);
    const float to = std::min(at + dash, length);
    if (to <= from) continue;
    list.AddLine(ImVec2(a.x + step.x * from, a.y + step.y * from), ImVec2(a.x + step.x * to, a.y + step.y * to), colour, width);
  }
  return std::fmod(carried + length, 2 * dash);
}

/// Piece by piece, so that a line whose ends are out of sight still shows its middle.
void draw_flat(ImDrawList& list, const Theme& theme, const ScreenPlace& place, std::span<const PathPoint> points,
               const LineLook& look) {
  std::vector<std::optional<ImVec2>> screen;
  screen.reserve(points.size());
  for (const PathPoint& point : points) screen.push_back(place(point));
  const float width = theme.px(look.width);
  for (const bool under : {true, false}) {
    float carried = 0;
    for (std::size_t i = 1; i < screen.size(); ++i) {
      const auto& a = screen[i - 1];
      const auto& b = screen[i];
      if (!a || !b) continue;
      if (under) {
        list.AddLine(*a, *b, look.casing, width + theme.px(2 * look.casing_width));
      } else if (look.dashed) {
        carried = draw_dashes(list, *a, *b, look.colour, width, theme.px(dash_length), carried);
      } else {
        list.AddLine(*a, *b, look.colour, width);
      }
    }
  }
}

}  // namespace

ViewPen flat_pen(ImDrawList& list, const Theme& theme, ScreenPlace place) {
  const auto line = [&list, &theme, place](std::span<const PathPoint> points, const LineLook& look) {
    draw_flat(list, theme, place, points, look);
  };
  return {std::move(place), line, [](PathPoint) { return false; }};
}

ImU32 mark_colour(const ViewPen& pen, PathPoint at, ImU32 colour) {
  if (!pen.hidden(at)) return colour;
  const auto alpha = ImU32(float((colour >> IM_COL32_A_SHIFT) & 255) * hidden_alpha);
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

std::vector<PathPoint> along_ground(PathPoint from, PathPoint to, float step) {
  const PathPoint ends[] = {from, to};
  return along_ground(ends, step);
}

std::vector<PathPoint> along_ground(std::span<const PathPoint> places, float step) {
  std::vector<PathPoint> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PathPoint to = places[i];
    if (i > 0) {
      const PathPoint from = places[i - 1];
      const float length = std::hypot(to.x - from.x, to.y - from.y);
      const int pieces = std::clamp(int(std::ceil(length / std::max(step, 1e-3F))), 1, 4096);
      for (int piece = 1; piece < pieces; ++piece) {
        const float share = float(piece) / float(pieces);
        result.push_back({from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share});
      }
    }
    result.push_back(to);
  }
  return result;
}

std::vector<PathPoint> ring_around(PathPoint centre, float radius) {
  constexpr int corners = 64;
  std::vector<PathPoint> ring;
  for (int i = 0; i <= corners; ++i) {
    const float angle = 6.2831853F * float(i % corners) / corners;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

}  // namespace biotope
