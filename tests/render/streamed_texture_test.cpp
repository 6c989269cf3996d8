#include "render/streamed_texture.hpp"

#include <catch2/catch.hpp>

#include "render/offscreen_context.hpp"
#include "render/streamed_grid.hpp"

using namespace biotope;

namespace {

constexpr int side = 600;

std::shared_ptr<const TexelPyramid<Rgba>> plain(std::uint8_t tone) {
  auto pyramid = std::make_shared<TexelPyramid<Rgba>>();
  pyramid->levels.push_back(shared_tiles<Rgba>(Grid<Rgba>(side, side, Rgba{tone, tone, tone, 255}), nullptr));
  add_mipmaps<Rgba>(*pyramid, nullptr);
  return pyramid;
}

std::vector<Rgba> texels_of(GLuint texture, int level) {
  std::vector<Rgba> out(std::size_t(side >> level) * std::size_t(side >> level));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture, level, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(out.size() * sizeof(Rgba)), out.data());
  return out;
}

bool all(const std::vector<Rgba>& texels, std::uint8_t tone) {
  return std::all_of(texels.begin(), texels.end(), [&](const Rgba& texel) { return texel == Rgba{tone, tone, tone, 255}; });
}

UploadBudget of_bytes(std::size_t bytes) {
  UploadBudget budget = UploadBudget::unlimited();
  budget.bytes = bytes;
  return budget;
}

}  // namespace

TEST_CASE("a large picture comes in over several frames, and the one before stays whole until then") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  StreamedTexture<Rgba> texture({});
  UploadBudget all_at_once = UploadBudget::unlimited();
  texture.want(plain(50));
  REQUIRE(texture.upload(all_at_once));
  texture.show();
  CHECK(all(texels_of(texture.name(), 0), 50));
  CHECK(all(texels_of(texture.name(), 2), 50));
  texture.want(plain(200));
  int frames = 1;
  for (UploadBudget budget = of_bytes(100000); !texture.upload(budget); budget = of_bytes(100000)) {
    ++frames;
    CHECK(all(texels_of(texture.name(), 0), 50));
  }
  CHECK(frames >= 15);  // 1.4 MB and its mipmaps
  CHECK(frames < 40);
  texture.show();
  CHECK(all(texels_of(texture.name(), 0), 200));
  CHECK(all(texels_of(texture.name(), 3), 200));
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("where one tile differs only that is uploaded, when it is shown") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  StreamedTexture<Rgba> texture({});
  UploadBudget all_at_once = UploadBudget::unlimited();
  const auto before = plain(50);
  texture.want(before);
  REQUIRE(texture.upload(all_at_once));
  texture.show();
  const GLuint name = texture.name();
  Grid<Rgba> texels = before->levels.front().to_grid();
  texels(70, 10) = {255, 0, 0, 255};
  auto after = std::make_shared<TexelPyramid<Rgba>>();
  after->levels.push_back(shared_tiles(texels, &before->levels.front()));
  add_mipmaps(*after, before.get());
  CHECK(after->levels.front().tile(0) == before->levels.front().tile(0));
  texture.want(after);
  UploadBudget nothing = of_bytes(0);
  REQUIRE(texture.upload(nothing));
  CHECK(all(texels_of(texture.name(), 0), 50));
  texture.show();
  CHECK(texture.name() == name);
  CHECK(texels_of(texture.name(), 0) == std::vector<Rgba>(texels.cells().begin(), texels.cells().end()));
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a grid comes in by bands of rows") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  auto grid = std::make_shared<Grid<Rgba>>(side, side);
  for (std::size_t i = 0; i < grid->size(); ++i) (*grid)[i] = {std::uint8_t(i), std::uint8_t(i / 256), 3, 255};
  StreamedGrid<Rgba> texture;
  texture.want(grid, {grid.get()}, {});
  CHECK(texture.coming());
  int frames = 1;
  for (UploadBudget budget = of_bytes(1); !texture.upload(budget); budget = of_bytes(1)) ++frames;
  CHECK(frames == 7);  // its storage, then 1406 KiB in bands of 256
  texture.show();
  CHECK_FALSE(texture.coming());
  CHECK(texels_of(texture.texture().name(), 0) == std::vector<Rgba>(grid->cells().begin(), grid->cells().end()));
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("what was shown before is filled anew for the next picture, and given back where none comes") {
  const auto context = OffscreenContext::create();
  if (!context) return;
  StreamedGrid<Rgba> texture;
  UploadBudget all_at_once = UploadBudget::unlimited();
  const auto show = [&](int width, std::uint8_t tone) {
    const auto grid = std::make_shared<Grid<Rgba>>(width, side, Rgba{tone, tone, tone, 255});
    texture.want(grid, {grid.get()}, {});
    REQUIRE(texture.upload(all_at_once));
    texture.show();
    return texture.texture().name();
  };
  const GLuint first = show(side, 1);
  const GLuint second = show(side, 2);
  CHECK(second != first);
  CHECK(show(side, 3) == first);
  CHECK(all(texels_of(first, 0), 3));
  CHECK(show(side / 2, 4) != second);
  CHECK(glGetError() == GL_NO_ERROR);

  SpareTexture spare;
  const TextureShape shape{GL_RGBA8, side, side, 1, {}};
  spare.keep(std::move(*spare.take(shape, all_at_once)), shape);
  const auto now = SpareTexture::Clock::now();
  spare.tidy(all_at_once, now);
  CHECK(bool(spare));
  UploadBudget spent = of_bytes(0);
  spare.tidy(spent, now + std::chrono::minutes(1));
  CHECK(bool(spare));
  spare.tidy(all_at_once, now + std::chrono::minutes(1));
  CHECK_FALSE(bool(spare));
  CHECK_FALSE(spare.take(shape, spent));
}
