#include "ui/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace biotope {
namespace {

constexpr std::array<std::string_view, 12> month_names{"January", "February", "March",     "April",   "May",      "June",
                                                       "July",    "August",   "September", "October", "November", "December"};

std::string with_decimals(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

/// Puts a space between groups of three digits of numbers of five digits and more.
std::string grouped(std::string digits) {
  const std::size_t sign = digits.starts_with('-') ? 1 : 0;
  if (digits.size() - sign < 5) return digits;
  for (std::size_t i = digits.size() - 3; i > sign && i < digits.size(); i -= 3) digits.insert(i, " ");
  return digits;
}

}  // namespace

std::string format_number(double value) {
  if (!std::isfinite(value)) return "unknown";
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size >= 99.95) return grouped(with_decimals(value, 0));
  if (size >= 9.995) return with_decimals(value, 1);
  if (size >= 0.9995) return with_decimals(value, 2);
  if (size >= 0.001) return with_decimals(value, 2 - int(std::floor(std::log10(size * 1.0005))));
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

std::string format_value(double value, std::string_view unit) {
  if (unit == "%") return format_percent(value);
  std::string text = format_number(value);
  if (std::isfinite(value) && !unit.empty()) text.append(" ").append(unit);
  return text;
}

std::string format_percent(double fraction) {
  if (!std::isfinite(fraction)) return "unknown";
  const double percent = fraction * 100;
  if (percent == 0) return "0 %";
  if (std::abs(percent) < 0.05) return percent > 0 ? "< 0.1 %" : "> -0.1 %";
  return with_decimals(percent, std::abs(percent) < 9.95 ? 1 : 0) + " %";
}

std::string format_length(double metres) {
  if (!std::isfinite(metres)) return "unknown";
  if (std::abs(metres) < 1000) return format_number(metres) + " m";
  return format_number(metres / 1000) + " km";
}

std::string format_round_number(double value) {
  std::string number = format_number(value);
  if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number;
}

std::string format_round_length(double metres) {
  if (!std::isfinite(metres)) return "unknown";
  const bool far = std::abs(metres) >= 1000;
  return format_round_number(far ? metres / 1000 : metres) + (far ? " km" : " m");
}

std::string format_clock(double hour) {
  if (!std::isfinite(hour)) return "unknown";
  const auto minutes = (std::lround(hour * 60) % 1440 + 1440) % 1440;
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%02ld:%02ld", minutes / 60, minutes % 60);
  return text.data();
}

std::string format_bytes(std::size_t bytes) {
  constexpr double step = 1024;
  if (bytes < 1024) return std::to_string(bytes) + " B";
  double amount = double(bytes) / step;
  std::size_t unit = 0;
  constexpr std::array<const char*, 4> units{"KiB", "MiB", "GiB", "TiB"};
  for (; amount >= step && unit + 1 < units.size(); ++unit) amount /= step;
  return format_number(amount) + " " + units[unit];
}

std::string format_count(double count) {
  if (!std::isfinite(count)) return "unknown";
  return grouped(with_decimals(count, 0));
}

std::string_view month_name(int month) { return month_names[std::size_t(std::clamp(month, 0, 11))]; }
std::string_view short_month_name(int month) { return month_name(month).substr(0, 3); }

}  // namespace biotope
