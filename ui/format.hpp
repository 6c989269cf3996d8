#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace biotope {

/// A number with three significant digits and thousands apart ("12 300", "4.56", "0.012"); "unknown" for NaN and infinities.
[[nodiscard]] std::string format_number(double value);
/// The same with a unit after a space; "%" multiplies by 100. An unknown value has no unit; an empty unit adds nothing.
[[nodiscard]] std::string format_value(double value, std::string_view unit);
/// A fraction 0..1 as percents: "0 %", "0.4 %", "37 %".
[[nodiscard]] std::string format_percent(double fraction);
/// Metres as "850 m" or "3.2 km".
[[nodiscard]] std::string format_length(double metres);
/// A number that is round by itself, without the zeros that claim more: "2", "0.25".
[[nodiscard]] std::string format_round_number(double value);
/// A length that is round by itself, without the zeros that claim more: "1 km", "2.5 km", "200 m".
[[nodiscard]] std::string format_round_length(double metres);
/// Hour of the day (any real number) as "06:40".
[[nodiscard]] std::string format_clock(double hour);
/// "512 B", "3.4 MB".
[[nodiscard]] std::string format_bytes(std::size_t bytes);
/// A whole number with thousands apart.
[[nodiscard]] std::string format_count(double count);
/// "January" .. "December" for month 0..11, and its first three letters.
[[nodiscard]] std::string_view month_name(int month);
[[nodiscard]] std::string_view short_month_name(int month);

}  // namespace biotope
