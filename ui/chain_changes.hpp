#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "core/document/history.hpp"
#include "core/species/species_library.hpp"
#include "ui/species_figures.hpp"

namespace biotope {

/// What an edit did to one species: of its amount relative to before (0.1 is 10 % more; NaN where there was nothing), of its
/// surplus relative to the growth before.
struct SpeciesChange {
  int species = 0;
  double amount = 0;
  double surplus = 0;
  /// The greater of both, without sign; a species that appeared or died out counts 1.
  double strength = 0;
};

/// Species that changed by at least `least` (relative), the strongest first; ties in species order.
[[nodiscard]] std::vector<SpeciesChange> changes_between(const std::vector<SpeciesFigures>& before,
                                                         const std::vector<SpeciesFigures>& after, double least = 0.002);

/// "-18 %", "+4 %", "+0.4 %".
[[nodiscard]] std::string format_change(double relative);

/// "Reindeer -18 %, Wolf -6 %, grass surplus +4 %", at most `most` parts; "Nothing else changed" without any.
[[nodiscard]] std::string changes_text(const FoodWeb& web, const std::vector<SpeciesChange>& changes, std::size_t most);

/// Follows the figures of the landscape from edit to edit, so that what an edit did is told once all of it is computed.
class ChainChanges {
 public:
  /// New figures of a complete landscape that answers document revision `answered`; `posted` is the newest revision and `editing`
  /// tells that a stroke is still going on. Returns true when the answer to an edit is whole.
  bool follow(const std::vector<SpeciesFigures>& figures, std::uint64_t answered, std::uint64_t posted, bool editing);
  /// Another landscape: forgets.
  void forget();
  /// Document revision `revision` was posted; it is what `edit` made.
  void note_posted(std::uint64_t revision, std::string edit);
  /// The edit that `changes` is the answer to: the newest that the figures know of; empty before any.
  [[nodiscard]] const std::string& answered_edit() const { return answered_edit_; }
  /// What the last edit did, so far.
  [[nodiscard]] const std::vector<SpeciesChange>& changes() const { return changes_; }

 private:
  std::vector<SpeciesFigures> before_;
  std::uint64_t before_revision_ = 0;
  bool answering_ = false;
  std::vector<SpeciesFigures> latest_;
  std::uint64_t latest_revision_ = 0;
  std::vector<SpeciesChange> changes_;
  std::deque<std::pair<std::uint64_t, std::string>> posted_;
  std::string answered_edit_;
};

/// What a person did last, in words: a step of the history ("Paint oak"), "Undo: Paint oak" where the history went back from
/// `position_before`, or that a stroke is going on.
[[nodiscard]] std::string last_edit_words(const History& history, std::size_t position_before, bool stroking);

}  // namespace biotope
