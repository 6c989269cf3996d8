#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace biotope {

/// Chooses whose next unit brings shares closest to the desired ones (least squared error; ties: the first added).
class ShareChoice {
 public:
  /// A competitor with its desired share and the size of its unit.
  void add(double desired, std::int64_t unit) {
    competitors_.push_back({desired, unit, 0});
    if (std::find(units_.begin(), units_.end(), unit) == units_.end()) units_.push_back(unit);
  }
  void give(std::size_t i) {
    competitors_[i].given += double(competitors_[i].unit);
    total_ += competitors_[i].unit;
  }
  [[nodiscard]] std::int64_t total() const { return total_; }

  /// The competitor to give to, among those for whom `open(i)` holds; -1 when there is none.
  template <class Open>
  [[nodiscard]] int closest(const Open& open) const {
    int best = -1;
    double least = 0;
    for (const std::int64_t unit : units_) {
      const int i = furthest_behind(unit, open);
      if (i < 0 || units_.size() == 1) {
        best = std::max(best, i);
        continue;
      }
      const double change = error_change(std::size_t(i));
      if (best < 0 || change < least || (change == least && i < best)) {
        best = i;
        least = change;
      }
    }
    return best;
  }

 private:
  struct Competitor {
    double desired = 0;
    std::int64_t unit = 1;
    double given = 0;  ///< whole units: exact
  };

  /// Among competitors of one unit size the least error is that of whoever lacks most: for a new total T, the sum over all of
  /// (desired - given / T)^2 changes by what grows with (given - desired T) of the one who gets the unit.
  template <class Open>
  [[nodiscard]] int furthest_behind(std::int64_t unit, const Open& open) const {
    int best = -1;
    double most = 0;
    const auto total = double(total_ + unit);
    for (std::size_t i = 0; i < competitors_.size(); ++i) {
      const Competitor& c = competitors_[i];
      if (c.unit != unit || !open(i)) continue;
      const double lacking = c.desired * total - c.given;
      if (best >= 0 && lacking <= most) continue;
      best = int(i);
      most = lacking;
    }
    return best;
  }

  /// How the squared error of shares changes with a unit for i. With errors e = desired - share and w the unit's part of the
  /// new total, shares become share (1 - w), plus w for i: written so that no large numbers cancel.
  [[nodiscard]] double error_change(std::size_t i) const {
    double error_by_share = 0;
    double share_squares = 0;
    for (const Competitor& c : competitors_) {
      const double share = share_of(c);
      error_by_share += (c.desired - share) * share;
      share_squares += share * share;
    }
    const double own = share_of(competitors_[i]);
    const double w = double(competitors_[i].unit) / double(total_ + competitors_[i].unit);
    return w * (2 * (error_by_share - (competitors_[i].desired - own)) + w * (share_squares - 2 * own + 1));
  }

  [[nodiscard]] double share_of(const Competitor& c) const { return total_ > 0 ? c.given / double(total_) : 0; }

  std::vector<Competitor> competitors_;
  std::vector<std::int64_t> units_;
  std::int64_t total_ = 0;
};

}  // namespace biotope
