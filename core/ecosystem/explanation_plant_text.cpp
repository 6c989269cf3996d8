#include "core/ecosystem/explanation_plant_text.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

namespace biotope {

namespace {

constexpr std::array<std::string_view, months> month_names{"January", "February", "March",     "April",   "May",      "June",
                                                           "July",    "August",   "September", "October", "November", "December"};

struct Words {
  std::string_view name;
  std::string_view too_low;
  std::string_view too_high;
};

Words words_of(Resource resource) {
  switch (resource) {
    case Resource::illumination:
      return {"Illumination", "too dark", "too bright"};
    case Resource::temperature:
      return {"Temperature", "too cold", "too warm"};
    case Resource::moisture:
      return {"Moisture", "too dry", "too wet"};
  }
  return {};
}

int next_month(int month) { return (month + 1) % months; }

/// Joins with commas and a last 'and'.
std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

}  // namespace

std::string month_text(int month) { return std::string(month_names[std::size_t(month)]); }

std::string months_text(const MonthSet& set) {
  if (std::ranges::all_of(set, [](bool in) { return in; })) return "all year";
  std::vector<std::string> runs;
  for (int first = 0; first < months; ++first) {
    const int before = (first + months - 1) % months;
    if (!set[std::size_t(first)] || set[std::size_t(before)]) continue;
    int last = first;
    while (set[std::size_t(next_month(last))]) last = next_month(last);
    runs.push_back(first == last ? "in " + month_text(first) : "from " + month_text(first) + " to " + month_text(last));
  }
  return join(runs);
}

YearMisfit year_misfit(Range range, const std::array<float, months>& year) {
  YearMisfit misfit;
  float worst = 0;
  for (int month = 0; month < months; ++month) {
    const float value = year[std::size_t(month)];
    const float missing = std::max(range.low - value, 0.0F);
    const float excess = std::max(value - range.high, 0.0F);
    misfit.too_low[std::size_t(month)] = missing > 0;
    misfit.too_high[std::size_t(month)] = excess > 0;
    misfit.months_low += missing > 0 ? 1 : 0;
    misfit.months_high += excess > 0 ? 1 : 0;
    if (std::max(missing, excess) > worst) {
      worst = std::max(missing, excess);
      misfit.worst_month = month;
      misfit.missing = missing;
      misfit.excess = excess;
    }
  }
  return misfit;
}

std::string misfit_text(Resource resource, const YearMisfit& misfit) {
  const Words words = words_of(resource);
  std::vector<std::string> parts;
  if (misfit.months_low > 0) parts.push_back(std::string(words.too_low) + " " + months_text(misfit.too_low));
  if (misfit.months_high > 0) parts.push_back(std::string(words.too_high) + " " + months_text(misfit.too_high));
  return join(parts);
}

std::string index_text(Resource resource, float index) {
  const std::string text = number_text(double(index), 1);
  if (resource != Resource::temperature) return text;
  return text + " (" + number_text(temperature_scale.physical(double(index)), 0) + " deg C)";
}

std::string resource_text(Resource resource) { return std::string(words_of(resource).name); }

std::string number_text(double value, int decimals) {
  std::array<char, 64> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result(text.data(), std::size_t(std::max(length, 0)));
  return result == "-0" ? "0" : result;
}

std::string percent_text(double fraction) { return number_text(100 * fraction, 0) + " %"; }

}  // namespace biotope
