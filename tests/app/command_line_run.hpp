#pragma once

#include <unistd.h>
#include <catch2/catch.hpp>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "core/exchange/geotiff.hpp"
#include "tests/scenes/small_valley.hpp"

namespace biotope {

/// What running the program came to.
struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

inline Outcome run(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = run_command_line(arguments, out, err);
  return {code, out.str(), err.str()};
}

/// A folder with a small DEM in it, gone with the test.
class Workplace {
 public:
  Workplace() {
    static std::atomic<int> count{0};
    path_ =
        std::filesystem::temp_directory_path() / ("biotope-app-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
    Terrain valley = scenes::small_valley(96, 80);
    valley.georeference.transform = {0, 10, 0, 800, 0, -10};
    if (!write_geotiff(dem(), valley.height, valley)) FAIL("no DEM to test with");
  }
  ~Workplace() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  [[nodiscard]] std::string at(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::string dem() const { return at("valley.tif"); }
  /// Files and folders in it.
  [[nodiscard]] std::size_t entries() const {
    return std::size_t(std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }
  /// An edit script of these edits.
  [[nodiscard]] std::string script(const std::string& edits, const std::string& name = "edits.json") const {
    std::ofstream(at(name)) << R"({"format": "biotope-edits", "version": 1, "edits": [)" << edits << "]}";
    return at(name);
  }

 private:
  std::filesystem::path path_;
};

inline std::string file_bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace biotope
