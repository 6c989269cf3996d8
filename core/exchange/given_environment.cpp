#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/exchange/geotiff.hpp"
#include "core/exchange/open_input.hpp"

namespace biotope {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, monthly_resources> resource_names{"illumination", "temperature", "moisture"};

std::string cell_text(const Grid<float>& map, std::size_t cell) {
  return "column " + std::to_string(cell % std::size_t(map.width())) + ", row " +
         std::to_string(cell / std::size_t(map.width()));
}

std::string number_text(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", double(value));
  return text;
}

Result<Grid<float>> read_map(const fs::path& file, int width, int height) {
  auto map = read_raster(file);
  if (!map) return map;
  if (map->width() == width && map->height() == height) return map;
  return fail(file.string() + ": is " + std::to_string(map->width()) + " x " + std::to_string(map->height()) +
              " cells, but the terrain is " + std::to_string(width) + " x " + std::to_string(height) +
              "; they must be the same.");
}

Result<std::shared_ptr<const Grid<float>>> read_index_map(const fs::path& file, int width, int height) {
  auto map = read_map(file, width, height);
  if (!map) return tl::unexpected(map.error());
  const auto cells = map->cells();
  const auto wrong = std::find_if(cells.begin(), cells.end(), [](float value) { return !(value >= 1 && value <= 9); });
  if (wrong != cells.end()) {
    return fail(file.string() + ": " + cell_text(*map, std::size_t(wrong - cells.begin())) + " is " +
                number_text(*wrong) + "; expected the index scale 1..9.");
  }
  return std::make_shared<const Grid<float>>(std::move(*map));
}

Result<std::shared_ptr<const Grid<Geology>>> read_geology(const fs::path& file, int width, int height) {
  const auto map = read_map(file, width, height);
  if (!map) return tl::unexpected(map.error());
  auto geology = std::make_shared<Grid<Geology>>(width, height);
  for (std::size_t i = 0; i < map->size(); ++i) {
    const float value = (*map)[i];
    if (!(value >= 0 && value < float(geology_classes)) || value != std::floor(value)) {
      return fail(file.string() + ": " + cell_text(*map, i) + " is " + number_text(value) +
                  "; expected a class 0 (limestone), 1 (water), 2 (marl), 3 (scree) or 4 (alluvium).");
    }
    (*geology)[i] = Geology(int(value));
  }
  return geology;
}

fs::path month_file(const fs::path& folder, std::string_view resource, int month) {
  char number[8];
  std::snprintf(number, sizeof number, "-%02d", month + 1);
  return folder / (std::string(resource) + number + ".tif");
}

/// An Error for a name that means to be a monthly map but is none ("moisture-13.tif", "moisture-1.tif").
Status check_names(const fs::path& folder, std::string_view resource) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(std::string(resource) + "-") || !name.ends_with(".tif")) continue;
    bool is_month = false;
    for (int month = 0; month < months; ++month) is_month |= month_file(folder, resource, month).filename() == name;
    if (!is_month) {
      return fail(entry.path().string() + ": is no month; expected " + std::string(resource) + "-01.tif to -12.tif.");
    }
  }
  return {};
}

Status read_months(const fs::path& folder, int resource, int width, int height, GivenEnvironment& given) {
  const std::string_view name = resource_names[std::size_t(resource)];
  if (const Status named = check_names(folder, name); !named) return named;
  std::vector<std::shared_ptr<const Grid<float>>> maps;
  std::optional<fs::path> missing;
  for (int month = 0; month < months; ++month) {
    const fs::path file = month_file(folder, name, month);
    if (!fs::exists(file)) {
      if (!missing) missing = file;
      continue;
    }
    auto map = read_index_map(file, width, height);
    if (!map) return tl::unexpected(map.error());
    maps.push_back(std::move(*map));
  }
  if (maps.empty()) return {};
  if (missing) return fail(missing->string() + ": is missing; " + std::string(name) + " needs all twelve months.");
  given.monthly[std::size_t(resource)] = std::move(maps);
  return {};
}

}  // namespace

Result<GivenEnvironment> load_given_environment(const fs::path& folder, int width, int height) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return fail(folder.string() + ": is not a folder of environment maps.");
  GivenEnvironment given;
  for (int resource = 0; resource < monthly_resources; ++resource) {
    if (const Status read = read_months(folder, resource, width, height, given); !read) {
      return tl::unexpected(read.error());
    }
  }
  const fs::path geology_file = folder / "geology.tif";
  if (fs::exists(geology_file)) {
    auto geology = read_geology(geology_file, width, height);
    if (!geology) return tl::unexpected(geology.error());
    given.geology = std::move(*geology);
  }
  const bool any = given.geology || std::any_of(given.monthly.begin(), given.monthly.end(),
                                                [](const auto& maps) { return !maps.empty(); });
  if (!any) {
    return fail(folder.string() + ": holds no environment map; expected illumination-01.tif to -12.tif, temperature-*, "
                "moisture-* or geology.tif.");
  }
  return given;
}

}  // namespace biotope
