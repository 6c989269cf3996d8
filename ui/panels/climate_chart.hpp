#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// What a month's value in the climate diagram is.
enum class ClimateQuantity { temperature, precipitation };

/// A climate with a month's mean temperature (degrees C; minimum and maximum keep their distance) or precipitation (mm) set, kept
/// within what the editor allows.
[[nodiscard]] Climate with_month(Climate climate, ClimateQuantity quantity, int month, double value);

/// Two charts of the year, temperature above and precipitation below. A drag moves a month's value; letting go makes it one step of
/// the history. A click also chooses the month.
void draw_climate_charts(const UiContext& ui);

}  // namespace biotope
