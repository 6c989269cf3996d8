#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/exchange/open_input.hpp"

namespace biotope {
namespace {

namespace fs = std::filesystem;

bool holds_assets(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(default_species_file(folder), ignored) && fs::is_directory(folder / "climates", ignored);
}

/// Places to look in, the likeliest first: installed beside the program, then the source tree above a build folder.
std::vector<fs::path> candidates() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  std::vector<fs::path> folders{program / ".." / "share" / "biotope", program / ".." / "share" / "biotope" / "assets"};
  for (fs::path parent = program; parent.has_relative_path(); parent = parent.parent_path()) {
    folders.push_back(parent / "assets");
  }
#ifdef BIOTOPE_SOURCE_ASSETS
  folders.emplace_back(BIOTOPE_SOURCE_ASSETS);
#endif
  return folders;
}

}  // namespace

fs::path default_species_file(const fs::path& assets) { return assets / "species" / "tautavel.json"; }

Result<fs::path> assets_folder() {
  if (const char* given = std::getenv("BIOTOPE_ASSETS"); given != nullptr && *given != '\0') {
    if (holds_assets(given)) return fs::path(given);
    return fail(std::string(given) + ": BIOTOPE_ASSETS names this folder, but it has no species/tautavel.json and "
                "climates/.");
  }
  const auto folders = candidates();
  const auto found = std::find_if(folders.begin(), folders.end(), holds_assets);
  if (found != folders.end()) return found->lexically_normal();
  return fail("The folder of species and climates is not found beside the program. Set BIOTOPE_ASSETS to it.");
}

}  // namespace biotope
