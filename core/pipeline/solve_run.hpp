#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/pipeline/solve_stages.hpp"
#include "core/pipeline/stage_clock.hpp"

namespace biotope {

/// One run over the operators, in topological order.
class SolveRun {
 public:
  /// `lasts`: whether the stages are for further runs.
  SolveRun(const Document& document, SolveCache::Stages& stages, bool lasts, const TaskContext& context,
           const PublishPartial& publish)
      : document_(document),
        stages_(stages),
        lasts_(lasts),
        context_(context),
        publish_(publish),
        maps_(std::make_shared<MapsSnapshot>()) {
    maps_->document = document;
  }

  [[nodiscard]] Result<std::shared_ptr<const MapsSnapshot>> all();

 private:
  using Step = Status (SolveRun::*)();
  using Steps = std::vector<std::pair<std::string, Step>>;

  Status perform(const Steps& steps);
  void publish_partial();
  [[nodiscard]] std::shared_ptr<const MapsSnapshot> whole_snapshot() const;

  Status land();
  Status life();
  Status life_on_plants();

  // What is of the whole map, as it was before the last edits (solve_as_before.cpp).
  Status nearby();
  Status environment_as_before();
  Status life_as_before();
  Status plants_as_before();

  Status species();
  Status ground();
  Status slopes();
  Status water();
  Status environment() { return environment_with(FarShade::exact); }
  Status environment_with(FarShade far_shade);
  Status plants();
  Status animals();
  Status animal_level(std::size_t index);
  Status travel();
  Status trails();
  Status daily_plans();
  Status overpainted();

  [[nodiscard]] EnvironmentInput environment_input() const;
  [[nodiscard]] std::vector<double> desired(int level) const;
  /// What every animal reads of the ground: where it can be.
  [[nodiscard]] InputPointers ground_pointers() const;
  [[nodiscard]] InputPointers level_pointers() const;

  const Document& document_;
  SolveCache::Stages& stages_;
  bool lasts_;
  const TaskContext& context_;
  const PublishPartial& publish_;
  std::shared_ptr<MapsSnapshot> maps_;
  std::shared_ptr<const FoodWeb> biology_;
  bool shown_nearby_ = false;
  /// Whether all that lives was shown already, with what is global as it was before.
  bool shown_as_before_ = false;
  StageClock clock_;
};

}  // namespace biotope
