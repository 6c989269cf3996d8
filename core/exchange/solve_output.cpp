#include "core/exchange/solve_output.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <vector>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/solve_reports.hpp"

namespace biotope {
namespace {

namespace fs = std::filesystem;

/// A folder beside the one asked for, removed with all in it when its owner goes; so are the folders above it that had to be
/// made, unless something was put there.
class StagingFolder {
 public:
  explicit StagingFolder(const fs::path& folder)
      : folder_(folder),
        path_(folder.parent_path() / ("." + folder.filename().string() + "-" + std::to_string(::getpid()) + ".tmp")) {
    std::error_code ignored;
    for (fs::path above = path_.parent_path(); above.has_relative_path() && !fs::exists(above, ignored);
         above = above.parent_path()) {
      made_above_.push_back(above);
    }
  }
  ~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    for (const fs::path& above : made_above_) fs::remove(above, ignored);
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] Status make() const {
    std::error_code error;
    fs::create_directories(path_ / "maps", error);
    if (!error) return {};
    return fail(folder_.string() + ": cannot be written (" + error.message() + "). Is the folder above it writable?");
  }

 private:
  fs::path folder_;
  fs::path path_;
  std::vector<fs::path> made_above_;
};

/// Moves `from` to `to`, which is replaced when it is a file.
Status replace(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) return fail(to.string() + ": cannot be put in place (" + error.message() + ").");
  return {};
}

/// Whether a file of the folder of maps is one that this program writes.
bool is_own_map(const std::string& name) {
  if (!name.ends_with(".tif")) return false;
  if (name == "trails.tif" || name == "water.tif") return true;
  constexpr std::array<std::string_view, 5> kinds{"environment-", "density-", "surplus-", "regions-", "fitness-"};
  return std::any_of(kinds.begin(), kinds.end(), [&](std::string_view kind) { return name.starts_with(kind); });
}

/// Puts the new maps among what the folder holds, without those of an earlier run that were not written again.
Status move_maps_in(const fs::path& staging, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  std::vector<fs::path> stale;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (is_own_map(entry->path().filename().string())) stale.push_back(entry->path());
  }
  if (error) return fail(folder.string() + ": cannot be written (" + error.message() + ").");
  std::vector<fs::path> maps;
  for (const auto& entry : fs::directory_iterator(staging, error)) maps.push_back(entry.path());
  for (const fs::path& map : maps) {
    if (const Status moved = replace(map, folder / map.filename()); !moved) return moved;
  }
  for (const fs::path& map : stale) {
    const bool new_one =
        std::any_of(maps.begin(), maps.end(), [&](const fs::path& made) { return made.filename() == map.filename(); });
    if (!new_one) fs::remove(map, error);
  }
  return {};
}

/// The summary goes last: where it is new, all is.
Status move_in(const fs::path& staging, const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return replace(staging, folder);
  if (const Status moved = move_maps_in(staging / "maps", folder / "maps"); !moved) return moved;
  for (const char* name : {"trails.geojson", "plans.json", "graph.json", "summary.json"}) {
    if (const Status moved = replace(staging / name, folder / name); !moved) return moved;
  }
  return {};
}

/// The folder's absolute path without a slash at its end; an Error when it is there and cannot be one.
Result<fs::path> usable_folder(const fs::path& given) {
  if (given.empty()) return fail("The folder to write into has no name.");
  std::error_code error;
  fs::path folder = fs::absolute(given, error).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();
  for (const fs::path& path : {folder, folder / "maps"}) {
    if (fs::exists(path, error) && !fs::is_directory(path, error)) {
      return fail((path == folder ? given : given / "maps").string() + ": is there already and is no folder. Give another name.");
    }
  }
  for (const char* name : {"trails.geojson", "plans.json", "graph.json", "summary.json"}) {
    if (fs::is_directory(folder / name, error))
      return fail((given / name).string() + ": is a folder, where a file is to be written.");
  }
  if (fs::exists(folder, error) && ::access(folder.c_str(), W_OK) != 0) return fail(given.string() + ": is not writable.");
  return folder;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Status check_solve_folder(const fs::path& given_folder) {
  const auto folder = usable_folder(given_folder);
  if (!folder) return tl::unexpected(folder.error());
  return StagingFolder(*folder).make();
}

Status write_solve_output(const fs::path& given_folder, const MapsSnapshot& snapshot, const SolveOutputOptions& options,
                          const TaskContext& context) {
  const auto start = std::chrono::steady_clock::now();
  const auto folder = usable_folder(given_folder);
  if (!folder) return tl::unexpected(folder.error());
  const StagingFolder staging(*folder);
  if (const Status made = staging.make(); !made) return made;
  if (Status maps = write_maps(staging.path() / "maps", snapshot, options.all_maps, context); !maps) return maps;

  const auto write = [&](const char* name, const std::string& text) { return write_text(staging.path() / name, text); };
  if (Status trails = write("trails.geojson", trails_geojson(snapshot)); !trails) return trails;
  if (Status plans = write("plans.json", plans_json(snapshot)); !plans) return plans;
  if (Status graph = write("graph.json", graph_json(snapshot)); !graph) return graph;
  const std::string summary = summary_json(snapshot, options, milliseconds_since(start));
  if (Status written = write("summary.json", summary); !written) return written;
  return move_in(staging.path(), *folder);
}

}  // namespace biotope
