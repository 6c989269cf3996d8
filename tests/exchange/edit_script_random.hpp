#pragma once

#include <string>

#include "core/base/random.hpp"
#include "core/exchange/edit_script.hpp"

namespace biotope_test {

/// Random scripts with every kind of entry and odd numbers, for round trips.
class RandomScript {
 public:
  RandomScript(std::uint64_t seed, const std::vector<biotope::Species>& species, const biotope::Climate& climate)
      : seed_(seed), species_(species), climate_(climate) {}

  biotope::EditScript script(int entries) {
    biotope::EditScript script;
    if (coin()) {
      script.width = number(2, 16384);
      script.height = number(2, 16384);
    }
    for (int i = 0; i < entries; ++i) script.entries.push_back(entry(number(0, 11)));
    return script;
  }

  biotope::ScriptEntry entry(int kind) {
    using namespace biotope;
    switch (kind) {
      case 0:
        return {stroke()};
      case 1:
        return {fill()};
      case 2:
        return {select()};
      case 3:
        return {ClearEdit{layer()}};
      case 4: {
        ImageEntry image{layer(), file(), {}, {}, real(0, 1), filter()};
        if (coin()) image.low = real(-100, 100);
        if (coin()) image.high = real(-100, 100);
        return {image};
      }
      case 5: {
        MixEntry mix{layer(), layer(), LayerMix(number(0, 5)), coin() ? file() : ""};
        if (!mix.file.empty()) mix.from = mix.into;
        return {mix};
      }
      case 6:
        return {parts()};
      case 7:
        return {MaskEntry{coin() ? file() : ""}};
      case 8: {
        LockEntry lock{{}, coin() ? file() : ""};
        if (lock.file.empty()) lock.edit.how = LockEdit::How(number(0, 3));
        return {lock};
      }
      case 9: {
        GroupEntry group{coin() ? "Several: \"ä\"\n" : "", {}};
        for (int i = number(0, 3); i > 0; --i) group.entries.push_back(entry(number(0, 8)));
        return {group};
      }
      case 10:
        return {UndoEntry{number(1, 1000)}};
      default:
        return {RedoEntry{number(1, 1000)}};
    }
  }

  biotope::PartsPatch parts() {
    using namespace biotope;
    PartsPatch patch;
    if (coin()) patch.name = "Change \\ something";
    if (coin()) patch.title = coin() ? "" : "Vallée \"1\"";
    if (coin()) patch.seed = random_bits({seed_, ++count_});
    if (coin()) {
      patch.climate = climate_;
      patch.climate->precipitation[3] = double(real(0, 300)) / 3;
    }
    if (coin()) patch.species = species_patch();
    if (coin()) patch.use_proportions = std::map<int, bool>{{0, coin()}, {number(1, 5), coin()}};
    if (coin()) patch.inflows = std::vector<Inflow>{{number(0, 1000), number(0, 1000), double(real(0, 1e6)) / 7}};
    if (coin()) patch.placements = placements();
    if (coin()) patch.layer_states = std::map<LayerId, LayerState>{{layer(), {coin(), coin()}}, {layer(), {coin(), coin()}}};
    return patch;
  }

 private:
  bool coin() { return number(0, 1) == 1; }
  int number(int low, int high) { return biotope::random_int(low, high, {seed_, ++count_}); }
  float real(double low, double high) { return float(low + (high - low) * biotope::random_unit({seed_, ++count_})); }
  biotope::PathPoint point() { return {real(-100, 5000), real(-100, 5000)}; }
  std::string file() { return coin() ? "leaf.png" : "some files/é-" + std::to_string(number(1, 9)) + ".tif"; }

  biotope::LayerId layer() {
    static const std::array<const char*, 9> texts{"resource:moisture",   "resource:texture", "plant-density:quercus",
                                                  "animal-density:wolf", "geology:class",    "loss:quercus",
                                                  "passage:all",         "ground:height",    "plant-density:x:y"};
    return *biotope::layer_from_text(texts[std::size_t(number(0, 8))]);
  }

  biotope::BrushFilter filter() {
    using namespace biotope;
    BrushFilter filter;
    filter.use_selection = coin();
    for (int i = number(0, 2); i > 0; --i) {
      FilterCondition condition{FilterQuantity(number(0, 4)), {}, real(-10, 10), real(0, 90), real(0, 5), coin()};
      if (condition.quantity == FilterQuantity::map) condition.map = layer();
      filter.conditions.push_back(condition);
    }
    return filter;
  }

  biotope::Brush brush() {
    using namespace biotope;
    Brush brush;
    brush.mode = BrushMode(number(0, 9));
    brush.radius = real(0.5, 300);
    brush.strength = real(0, 1);
    brush.hardness = real(0, 1);
    brush.value = real(-1e5, 1e5);
    brush.floor = real(-3, 3);
    brush.falloff = Falloff(number(0, 3));
    brush.spacing = real(0.05, 2);
    brush.pressure_sizes = coin();
    brush.pressure_strengthens = coin();
    brush.noise_size = real(1, 100);
    brush.noise_seed = random_bits({seed_, ++count_});
    brush.stamp_turn = real(-180, 180);
    brush.stamp_turns_by_chance = coin();
    brush.clone_offset = point();
    brush.filter = filter();
    return brush;
  }

  std::vector<biotope::EditTarget> targets() {
    std::vector<biotope::EditTarget> list;
    for (int i = number(1, 3); i > 0; --i) {
      list.push_back({layer(), real(0, 1), {}, {}});
      if (coin()) list.back().value = real(-5, 5);
      if (coin()) list.back().floor = real(-5, 5);
    }
    return list;
  }

  template <class Entry>
  Entry painting() {
    Entry entry;
    entry.edit.targets = targets();
    entry.edit.brush = brush();
    if (coin() || entry.edit.brush.mode == biotope::BrushMode::clone) entry.edit.clone_from = layer();
    if (coin()) entry.stamp = file();
    return entry;
  }

  biotope::StrokeEntry stroke() {
    auto entry = painting<biotope::StrokeEntry>();
    for (int i = number(1, 20); i > 0; --i) {
      const auto at = point();
      entry.edit.points.push_back({at.x, at.y, coin() ? 1.0F : real(0, 1)});
    }
    return entry;
  }

  biotope::FillEntry fill() {
    auto entry = painting<biotope::FillEntry>();
    if (coin()) entry.edit.gradient = {point(), point(), real(-9, 9)};
    return entry;
  }

  biotope::SelectEdit select() {
    using namespace biotope;
    SelectEdit edit;
    edit.shape = SelectEdit::Shape(number(0, 6));
    edit.mode = SelectionMode(number(0, 3));
    for (int i = edit.shape == SelectEdit::Shape::rectangle ? 2
                 : edit.shape == SelectEdit::Shape::lasso   ? number(3, 30)
                                                            : 0;
         i > 0; --i) {
      edit.points.push_back(point());
    }
    if (edit.shape == SelectEdit::Shape::range)
      edit.range = {FilterQuantity::map, layer(), real(0, 1), real(1, 2), real(0, 1), coin()};
    if (edit.shape == SelectEdit::Shape::painted) edit.range.map = layer();
    return edit;
  }

  biotope::SpeciesPatch species_patch() {
    biotope::SpeciesPatch patch;
    for (int i = number(0, 2); i > 0; --i) {
      biotope::Species changed = species_[std::size_t(number(0, int(species_.size()) - 1))];
      changed.name += "-" + std::to_string(i);
      changed.colour[0] = real(0, 1);
      patch.changed.push_back(std::move(changed));
    }
    if (coin()) patch.removed = {"quercus", "wolf"};
    if (coin()) patch.order = {"b", "a"};
    return patch;
  }

  biotope::Placements placements() {
    biotope::Placements placed;
    placed.water.rivers.push_back({{point(), point(), point()}, double(real(0, 10))});
    placed.water.lakes.push_back({{point(), point(), point()}, real(0, 9)});
    placed.places.fords.push_back({point(), real(1, 20)});
    placed.places.exits.push_back({point(), real(1, 20)});
    placed.places.waypoints.push_back({point(), real(0, 1)});
    placed.places.pinned_trails.push_back({{point(), point()}, real(0, 1e5)});
    placed.places.forbidden_trails.push_back({{point(), point()}, real(1, 30)});
    placed.plans.push_back({"wolf", point(), number(0, 3), {{point(), real(0, 12), real(12, 24)}}});
    return placed;
  }

  std::uint64_t seed_;
  std::uint64_t count_ = 0;
  const std::vector<biotope::Species>& species_;
  const biotope::Climate& climate_;
};

}  // namespace biotope_test
