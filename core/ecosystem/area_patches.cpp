#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/ecosystem/cell_runs.hpp"
#include "core/ecosystem/disjoint_sets.hpp"

namespace biotope {
namespace {

/// Runs of the areas that are kept, cut at the lattice's columns where their area is large; `value` is the area.
RunTable cut_runs(const RunTable& table, const Areas& areas, const SplitRule& rule, const std::vector<char>& large) {
  RunTable cut{table.width, table.height, {}, {0}};
  for (int y = 0; y < table.height; ++y) {
    for (std::size_t i = table.row_start[std::size_t(y)]; i < table.row_start[std::size_t(y) + 1]; ++i) {
      const auto area = std::size_t(areas.area_of_run[i]);
      if (areas.areas[area].cells < rule.minimum_cells) continue;
      int x = table.runs[i].x0;
      while (large[area] && x / rule.side != (table.runs[i].x1 - 1) / rule.side) {
        const int next = (x / rule.side + 1) * rule.side;
        cut.runs.push_back({x, next, std::int64_t(area)});
        x = next;
      }
      cut.runs.push_back({x, table.runs[i].x1, std::int64_t(area)});
    }
    cut.row_start.push_back(cut.runs.size());
  }
  return cut;
}

/// Patches and the lengths of the borders between those of one area.
struct Neighbourhood {
  Areas patches;
  std::vector<std::map<std::int32_t, int>> border;

  void add_border(std::int32_t a, std::int32_t b, int cells) {
    if (a == b) return;
    border[std::size_t(a)][b] += cells;
    border[std::size_t(b)][a] += cells;
  }
};

Areas connect_within_lattice(const RunTable& cut, const SplitRule& rule, const std::vector<char>& large) {
  DisjointSets sets(cut.runs.size());
  for (int y = 1; y < cut.height; ++y) {
    const bool line = y % rule.side == 0;
    for_each_overlap(cut, y, [&](std::size_t above, std::size_t below, int) {
      const std::int64_t area = cut.runs[above].value;
      if (area == cut.runs[below].value && !(line && large[std::size_t(area)])) sets.unite(above, below);
    });
  }
  return numbered_areas(cut, sets);
}

Neighbourhood find_borders(const RunTable& cut, Areas patches) {
  Neighbourhood result{std::move(patches), {}};
  result.border.resize(result.patches.areas.size());
  const auto& patch_of = result.patches.area_of_run;
  for (int y = 0; y < cut.height; ++y) {
    for (std::size_t i = cut.row_start[std::size_t(y)] + 1; i < cut.row_start[std::size_t(y) + 1]; ++i) {
      if (cut.runs[i - 1].x1 == cut.runs[i].x0 && cut.runs[i - 1].value == cut.runs[i].value) {
        result.add_border(patch_of[i - 1], patch_of[i], 1);
      }
    }
    if (y == 0) continue;
    for_each_overlap(cut, y, [&](std::size_t above, std::size_t below, int cells) {
      if (cut.runs[above].value == cut.runs[below].value) result.add_border(patch_of[above], patch_of[below], cells);
    });
  }
  return result;
}

double diagonal(const Rect& rect) { return std::hypot(double(rect.width()), double(rect.height())); }

/// Joins slivers to their neighbours, smallest first; returns the patch that each patch became part of.
std::vector<std::int32_t> join_slivers(Neighbourhood& all, const SplitRule& rule) {
  auto& patches = all.patches.areas;
  std::vector<std::int32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::int32_t> joined = order;
  const auto root = [&](std::int32_t patch) {
    while (joined[std::size_t(patch)] != patch) patch = joined[std::size_t(patch)];
    return patch;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return patches[std::size_t(a)].cells < patches[std::size_t(b)].cells; });
  for (std::int32_t patch : order) {
    patch = root(patch);
    while (patches[std::size_t(patch)].cells < rule.sliver_cells) {
      std::int32_t best = -1;
      int longest_border = 0;
      for (const auto& [other, cells] : all.border[std::size_t(patch)]) {
        const Rect both = bounding(patches[std::size_t(patch)].bounds, patches[std::size_t(other)].bounds);
        if (cells > longest_border && diagonal(both) <= rule.longest) {
          best = other;
          longest_border = cells;
        }
      }
      if (best < 0) break;
      Area& kept = patches[std::size_t(best)];
      const Area& gone = patches[std::size_t(patch)];
      kept.cells += gone.cells;
      kept.sum_x += gone.sum_x;
      kept.sum_y += gone.sum_y;
      kept.bounds = bounding(kept.bounds, gone.bounds);
      for (const auto& [other, cells] : all.border[std::size_t(patch)]) {
        all.border[std::size_t(other)].erase(patch);
        all.add_border(best, other, cells);
      }
      all.border[std::size_t(patch)].clear();
      joined[std::size_t(patch)] = best;
      patch = best;
    }
  }
  for (auto& patch : joined) patch = root(patch);
  return joined;
}

}  // namespace

Patches split_into_patches(const RunTable& table, const Areas& areas, const SplitRule& rule) {
  std::vector<char> large(areas.areas.size());
  for (std::size_t i = 0; i < large.size(); ++i) {
    const Rect& bounds = areas.areas[i].bounds;
    large[i] = 2 * std::max(bounds.width(), bounds.height()) > 3 * rule.side;
  }
  Patches result;
  result.runs = cut_runs(table, areas, rule, large);
  Neighbourhood all = find_borders(result.runs, connect_within_lattice(result.runs, rule, large));
  const std::vector<std::int32_t> joined = join_slivers(all, rule);

  std::vector<std::int32_t> number(joined.size(), -1);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    auto& own = number[std::size_t(joined[i])];
    if (own < 0) {
      own = std::int32_t(result.patches.size());
      result.patches.push_back(all.patches.areas[std::size_t(joined[i])]);
      Area& patch = result.patches.back();
      patch.value = areas.areas[std::size_t(patch.value)].value;
    }
    number[i] = own;
  }
  for (std::size_t i = 0; i < result.runs.runs.size(); ++i) {
    result.runs.runs[i].value = number[std::size_t(all.patches.area_of_run[i])];
  }
  return result;
}

}  // namespace biotope
