#include "core/exchange/solve_output.hpp"

#include <unistd.h>

#include <array>
#include <chrono>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/solve_reports.hpp"

namespace biotope {
namespace {

namespace fs = std::filesystem;

/// A folder beside the one asked for, removed with all in it when its owner goes.
class StagingFolder {
 public:
  explicit StagingFolder(const fs::path& folder)
      : path_(folder.parent_path() / ("." + folder.filename().string() + "-" + std::to_string(::getpid()) + ".tmp")) {}
  ~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] Status make() const {
    std::error_code error;
    fs::create_directories(path_ / "maps", error);
    if (error) return fail(path_.string() + ": cannot be made (" + error.message() + "). Is the folder above it writable?");
    return {};
  }

 private:
  fs::path path_;
};

/// Moves `from` to `to`, which is replaced.
Status replace(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::remove_all(to, error);
  fs::rename(from, to, error);
  if (error) return fail(to.string() + ": cannot be put in place (" + error.message() + ").");
  return {};
}

Status move_in(const fs::path& staging, const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return replace(staging, folder);
  for (const char* name : {"maps", "trails.geojson", "plans.json", "graph.json", "summary.json"}) {
    if (const Status moved = replace(staging / name, folder / name); !moved) return moved;
  }
  return {};
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Status write_solve_output(const fs::path& given_folder, const MapsSnapshot& snapshot, const SolveOutputOptions& options,
                          const TaskContext& context) {
  const auto start = std::chrono::steady_clock::now();
  std::error_code error;
  fs::path folder = fs::absolute(given_folder, error).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    return fail(given_folder.string() + ": is there already and is no folder. Give another name.");
  }
  const StagingFolder staging(folder);
  if (const Status made = staging.make(); !made) return made;
  if (Status maps = write_maps(staging.path() / "maps", snapshot, options.all_maps, context); !maps) return maps;

  const auto write = [&](const char* name, const std::string& text) { return write_text(staging.path() / name, text); };
  if (Status trails = write("trails.geojson", trails_geojson(snapshot)); !trails) return trails;
  if (Status plans = write("plans.json", plans_json(snapshot)); !plans) return plans;
  if (Status graph = write("graph.json", graph_json(snapshot)); !graph) return graph;
  const std::string summary = summary_json(snapshot, options, milliseconds_since(start));
  if (Status written = write("summary.json", summary); !written) return written;
  return move_in(staging.path(), folder);
}

}  // namespace biotope
