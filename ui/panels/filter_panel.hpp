#pragma once

#include "core/document/brush_filter.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Where the brush may act: conditions that combine, the selection, and a switch that shows it on the map.
void draw_filter_section(const UiContext& ui);

/// The controls of one condition: its range and how softly it ends; true while it changes.
bool draw_condition(const UiContext& ui, FilterCondition& condition);
/// "Slope", "Distance to water", the map's title.
[[nodiscard]] std::string condition_title(const EditorState& state, const FilterCondition& condition);
/// Its range in words.
[[nodiscard]] std::string condition_text(const EditorState& state, const FilterCondition& condition);
/// A condition on a quantity with a range to start from.
[[nodiscard]] FilterCondition new_condition(const EditorState& state, FilterQuantity quantity, const LayerId& map = {});
/// Menu entries of everything a condition can look at; the condition that was chosen.
[[nodiscard]] std::optional<FilterCondition> condition_menu(const EditorState& state);

}  // namespace biotope
