#include "core/terrain/water_shaping.hpp"

#include <algorithm>
#include <utility>

#include "core/terrain/generations.hpp"
#include "core/terrain/shaping_parts.hpp"

namespace biotope {
namespace {

bool meet(const TileSet& a, const TileSet& b) { return a.tile_count() > 0 && (a & b).any(); }

/// Takes over what is known of those that are drawn as before, in the same order; returns 1 for each that is new. Tiles of those
/// that are no more join `changed`.
template <class Drawn>
std::vector<char> taken_over(const std::vector<Drawn>& before, const std::vector<Drawn>& after, std::vector<TileSet>& touched,
                             TileSet& changed) {
  std::vector<char> is_new(after.size(), 1);
  std::vector<char> kept(before.size(), 0);
  std::vector<TileSet> next(after.size());
  std::size_t from = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto same = std::find(before.begin() + std::ptrdiff_t(from), before.end(), after[i]);
    if (same == before.end()) continue;
    const auto place = std::size_t(same - before.begin());
    next[i] = std::move(touched[place]);
    kept[place] = 1;
    is_new[i] = 0;
    from = place + 1;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (kept[i] == 0) changed |= touched[i];
  }
  touched = std::move(next);
  return is_new;
}

/// Chooses those that have to do with the tiles; whether some are new among the chosen.
bool choose(const std::vector<TileSet>& touched, const TileSet& tiles, std::vector<char>& chosen) {
  bool more = false;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (chosen[i] != 0 || !meet(touched[i], tiles)) continue;
    chosen[i] = 1;
    more = true;
  }
  return more;
}

}  // namespace

WaterShaping::Choice WaterShaping::exchange(const DrawnWater& water, TileSet& changed) {
  Choice choice{taken_over(water_.lakes, water.lakes, touched_by_lake_, changed),
                taken_over(water_.rivers, water.rivers, touched_by_river_, changed)};
  water_ = water;
  return choice;
}

bool WaterShaping::choose_met(Choice& choice, const TileSet& tiles) const {
  const bool lakes = choose(touched_by_lake_, tiles, choice.lakes);
  const bool rivers = choose(touched_by_river_, tiles, choice.rivers);
  return lakes || rivers;
}

TileSet WaterShaping::touched_by(const Choice& choice) const {
  TileSet tiles;
  const auto add = [&](const TileSet& touched) {
    if (tiles.tile_count() == 0) {
      tiles = touched;
    } else if (touched.tile_count() > 0) {
      tiles |= touched;
    }
  };
  for (std::size_t i = 0; i < choice.lakes.size(); ++i) {
    if (choice.lakes[i] != 0) add(touched_by_lake_[i]);
  }
  for (std::size_t i = 0; i < choice.rivers.size(); ++i) {
    if (choice.rivers[i] != 0) add(touched_by_river_[i]);
  }
  return tiles;
}

void WaterShaping::lay_chosen(const Choice& choice, Terrain& land) {
  const TileSet none(land.height.width(), land.height.height(), small_side);
  std::vector<LakeBasin> lakes;
  for (std::size_t i = 0; i < choice.lakes.size(); ++i) {
    if (choice.lakes[i] == 0) continue;
    touched_by_lake_[i] = none;
    dig_lake(land, water_.lakes[i], lakes, touched_by_lake_[i]);
  }
  std::vector<const DrawnRiver*> rivers;
  for (std::size_t i = 0; i < choice.rivers.size(); ++i) {
    if (choice.rivers[i] != 0) rivers.push_back(&water_.rivers[i]);
  }
  std::vector<TouchedTiles> touched(rivers.size(), none);
  carve_rivers(land, rivers, lakes, touched);
  for (std::size_t i = 0, carved = 0; i < choice.rivers.size(); ++i) {
    if (choice.rivers[i] != 0) touched_by_river_[i] = std::move(touched[carved++]);
  }
  laid_ = lakes.size() + rivers.size();
}

void WaterShaping::lay(const DrawnWater& water, Terrain& land) {
  water_ = water;
  touched_by_lake_.assign(water.lakes.size(), {});
  touched_by_river_.assign(water.rivers.size(), {});
  lay_chosen({std::vector<char>(water.lakes.size(), 1), std::vector<char>(water.rivers.size(), 1)}, land);
}

TileSet WaterShaping::follow(const Terrain& ground, const TileSet& changed, const DrawnWater& water, Terrain& land) {
  TileSet written = changed.in_tiles_of(small_side);
  laid_ = 0;
  Choice choice = exchange(water, written);
  bool any = std::ranges::count(choice.lakes, 1) + std::ranges::count(choice.rivers, 1) > 0;
  any |= choose_met(choice, written);
  if (!any) {
    copy_tiles(ground.height, land.height, written);
    return written;
  }
  // Lakes and rivers that are laid again may come to lie elsewhere, where they meet others.
  while (true) {
    if (const TileSet before = touched_by(choice); before.tile_count() > 0) written |= before;
    while (choose_met(choice, written)) written |= touched_by(choice);
    copy_tiles(ground.height, land.height, written);
    lay_chosen(choice, land);
    const TileSet after = touched_by(choice);
    written |= after;
    if (!choose_met(choice, after)) return written;
  }
}

}  // namespace biotope
