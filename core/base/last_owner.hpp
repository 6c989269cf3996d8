#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace biotope {

/// Holds on to things until nobody else does, so that a background thread frees them: giving back hundreds of megabytes takes
/// longer than a frame. Guard it with the mutex of its owner.
class LastOwner {
 public:
  /// Once is enough: two holds on one thing would each take the other for somebody else's.
  void keep(std::shared_ptr<const void> thing) {
    const auto same = [&](const auto& other) { return !other.owner_before(thing) && !thing.owner_before(other); };
    if (thing && std::none_of(kept_.begin(), kept_.end(), same)) kept_.push_back(std::move(thing));
  }
  /// Those that nobody else holds any more. Drop them with no lock held.
  [[nodiscard]] std::vector<std::shared_ptr<const void>> take_unused() {
    const auto unused =
        std::stable_partition(kept_.begin(), kept_.end(), [](const auto& thing) { return thing.use_count() > 1; });
    std::vector<std::shared_ptr<const void>> taken(std::make_move_iterator(unused), std::make_move_iterator(kept_.end()));
    kept_.erase(unused, kept_.end());
    return taken;
  }
  [[nodiscard]] bool empty() const { return kept_.empty(); }

 private:
  std::vector<std::shared_ptr<const void>> kept_;
};

}  // namespace biotope
