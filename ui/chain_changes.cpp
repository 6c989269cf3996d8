#include "ui/chain_changes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "ui/map_catalogue.hpp"

namespace biotope {
namespace {

/// Difference relative to before; nothing at all counts as 0, something out of nothing as NaN.
double relative(double before, double after) {
  if (!std::isfinite(before) || !std::isfinite(after)) return 0;
  if (std::abs(before) < 1e-12) return std::abs(after) < 1e-12 ? 0 : std::numeric_limits<double>::quiet_NaN();
  return (after - before) / std::abs(before);
}

/// Change of what is left over, relative to what grew: the surplus itself may be next to nothing, and would then change by
/// thousands of percents.
double surplus_change(const SpeciesFigures& before, const SpeciesFigures& after) {
  const double change = after.surplus() - before.surplus();
  return std::isfinite(change) && before.growth > 0 ? change / before.growth : 0;
}

double strength_of(double change) { return std::isfinite(change) ? std::abs(change) : 1; }

}  // namespace

std::vector<SpeciesChange> changes_between(const std::vector<SpeciesFigures>& before, const std::vector<SpeciesFigures>& after,
                                           double least) {
  std::vector<SpeciesChange> changes;
  if (before.size() != after.size()) return changes;
  for (std::size_t i = 0; i < before.size(); ++i) {
    SpeciesChange change{int(i), relative(before[i].amount, after[i].amount), surplus_change(before[i], after[i]), 0};
    change.strength = std::max(strength_of(change.amount), strength_of(change.surplus));
    if (change.strength >= least) changes.push_back(change);
  }
  std::stable_sort(changes.begin(), changes.end(), [](const auto& a, const auto& b) { return a.strength > b.strength; });
  return changes;
}

std::string format_change(double relative_change) {
  if (!std::isfinite(relative_change)) return "new";
  const double percent = 100 * relative_change;
  char text[32];
  if (std::abs(percent) >= 10) {
    std::snprintf(text, sizeof text, "%+.0f %%", percent);
  } else if (std::abs(percent) >= 1) {
    std::snprintf(text, sizeof text, "%+.1f %%", percent);
  } else {
    std::snprintf(text, sizeof text, "%+.2f %%", percent);
  }
  return text;
}

std::string changes_text(const FoodWeb& web, const std::vector<SpeciesChange>& changes, std::size_t most) {
  std::string text;
  std::size_t told = 0;
  for (const SpeciesChange& change : changes) {
    if (told == most) break;
    if (std::size_t(change.species) >= web.species.size()) continue;
    const bool by_amount = strength_of(change.amount) >= 0.5 * strength_of(change.surplus);
    if (told++ > 0) text += ", ";
    text += display_name(web.species[std::size_t(change.species)]);
    if (!by_amount) text += " surplus";
    text += " " + format_change(by_amount ? change.amount : change.surplus);
  }
  if (changes.size() > told) text += ", " + std::to_string(changes.size() - told) + " more";
  return text.empty() ? "Nothing else changed" : text;
}

bool ChainChanges::follow(const std::vector<SpeciesFigures>& figures, std::uint64_t answered, std::uint64_t posted,
                          bool editing) {
  if (before_.empty()) {
    before_ = latest_ = figures;
    before_revision_ = latest_revision_ = answered;
    return false;
  }
  if (!answering_) {
    // The first figures after an edit are compared with the last ones before it.
    before_ = latest_;
    before_revision_ = latest_revision_;
    answering_ = answered != before_revision_;
  }
  latest_ = figures;
  latest_revision_ = answered;
  if (!answering_) return false;
  changes_ = changes_between(before_, figures);
  while (!posted_.empty() && posted_.front().first <= answered) {
    answered_edit_ = std::move(posted_.front().second);
    posted_.pop_front();
  }
  if (editing || answered < posted) return false;
  answering_ = false;
  return true;
}

void ChainChanges::note_posted(std::uint64_t revision, std::string edit) { posted_.emplace_back(revision, std::move(edit)); }

std::string last_edit_words(const History& history, std::size_t position_before, bool stroking) {
  if (stroking) return "the stroke so far";
  const std::size_t position = history.position();
  if (position < position_before && position < history.size()) return "Undo: " + history.name(position);
  return position > 0 ? history.name(position - 1) : std::string();
}

void ChainChanges::forget() { *this = ChainChanges(); }

}  // namespace biotope
