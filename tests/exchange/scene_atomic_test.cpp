#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>

#include "core/exchange/scene_file.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

/// Until a file holds something else; a minute at most.
void wait_for_another(const std::filesystem::path& file, const std::string& bytes) {
  for (int i = 0; i < 12000 && bytes_of(file) == bytes; ++i) usleep(5000);
}

}  // namespace

TEST_CASE("a save on a full disk says so and leaves the old scene whole") {
  const TemporaryFolder folder;
  Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document));
  const std::string before = bytes_of(folder / "a.biotope");
  // No file may grow beyond a few KB: to the writer that is a full disk.
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &old) == 0);
  rlimit small = old;
  small.rlim_cur = 4096;
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  document.title = "second";
  const Status saved = save_scene(folder / "a.biotope", document);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &old) == 0);
  std::signal(SIGXFSZ, ignored);
  REQUIRE_FALSE(saved);
  CHECK_THAT(saved.error().message, Contains("a.biotope") && Contains("space on the disk"));
  CHECK(bytes_of(folder / "a.biotope") == before);
  CHECK(folder.names().size() == 1);
}

// Run by the test below in a process of its own.
TEST_CASE("save again and again until killed", "[.saver]") {
  const char* const file = std::getenv("BIOTOPE_SAVE_TO");
  if (file == nullptr) return;
  Document document = full_document();
  for (int turn = 0;; ++turn) {
    document.title = std::to_string(turn);
    REQUIRE(save_scene(file, document));
  }
}

TEST_CASE("an editor killed while it saves leaves a whole scene") {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.biotope").string();
  const Document document = full_document();
  REQUIRE(save_scene(file, document));
  bool saved_again = false;
  for (int attempt = 0; attempt < 5; ++attempt) {
    const std::string saved = bytes_of(file);
    const pid_t child = fork();
    if (child == 0) {
      setenv("BIOTOPE_SAVE_TO", file.c_str(), 1);
      execl("/proc/self/exe", "test_exchange", "[saver]", static_cast<char*>(nullptr));
      _exit(1);
    }
    REQUIRE(child > 0);
    wait_for_another(file, saved);
    usleep(useconds_t(17000 * attempt));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const auto loaded = load_scene(file);
    if (!loaded) FAIL(loaded.error().message);
    CHECK(loaded->layers.size() == document.layers.size());
    saved_again = saved_again || loaded->title != document.title;
  }
  CHECK(saved_again);
}

TEST_CASE("saving over a link keeps the link, and saving keeps who may read the file") {
  const TemporaryFolder folder;
  const Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document));
  std::filesystem::permissions(folder / "a.biotope", std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  std::filesystem::create_symlink(folder / "a.biotope", folder / "link.biotope");
  REQUIRE(save_scene(folder / "link.biotope", document));
  CHECK(std::filesystem::is_symlink(folder / "link.biotope"));
  CHECK_FALSE(std::filesystem::is_symlink(folder / "a.biotope"));
  CHECK(std::filesystem::status(folder / "a.biotope").permissions() ==
        (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write));
}

TEST_CASE("what did not change is not packed again, and the bytes are the same") {
  const TemporaryFolder folder;
  Document document = full_document();
  SceneCache cache;
  REQUIRE(save_scene(folder / "a.biotope", document, &cache));
  const auto terrain = cache.entries.at("terrain.tif").bytes;
  document.title = "second";
  PaintLayer other(160, 128);
  other.set(1, 1, {2, 1});
  document.layers[{LayerKind::resource, "moisture"}] = std::make_shared<const PaintLayer>(other);
  REQUIRE(save_scene(folder / "a.biotope", document, &cache));
  CHECK(cache.entries.at("terrain.tif").bytes == terrain);
  REQUIRE(save_scene(folder / "b.biotope", document));
  CHECK(bytes_of(folder / "a.biotope") == bytes_of(folder / "b.biotope"));
  document.layers.clear();
  REQUIRE(save_scene(folder / "a.biotope", document, &cache));
  CHECK_FALSE(cache.entries.contains("layers/1-resource.tif"));
}
