#pragma once

namespace biotope {

/// The month in which the northern hemisphere has the season of a month at a latitude (degrees).
[[nodiscard]] constexpr int northern_month(int month, double latitude) { return latitude >= 0 ? month : (month + 6) % 12; }

}  // namespace biotope
