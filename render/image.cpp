#include "render/image.hpp"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace biotope {

namespace {
struct FreePixels {
  void operator()(unsigned char* pixels) const { stbi_image_free(pixels); }
};
struct FreeEncoded {
  void operator()(unsigned char* bytes) const { STBIW_FREE(bytes); }
};

/// A name beside a file that nothing else uses.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> count{0};
  const std::string suffix = std::to_string(::getpid()) + "-" + std::to_string(count.fetch_add(1));
  return file.parent_path() / ("." + file.stem().string() + "-" + suffix + ".tmp" + file.extension().string());
}
}  // namespace

Status write_png(const std::filesystem::path& file, const Image& image, const TaskContext& task) {
  const std::size_t expected = std::size_t(image.width) * std::size_t(image.height) * 4;
  if (image.width <= 0 || image.height <= 0 || image.rgba.size() != expected) {
    return fail("Cannot write " + file.string() + ": the picture is empty.");
  }
  int length = 0;
  const std::unique_ptr<unsigned char, FreeEncoded> encoded(
      stbi_write_png_to_mem(image.rgba.data(), image.width * 4, image.width, image.height, 4, &length));
  if (!encoded) return fail("Cannot write " + file.string() + ": not enough memory to encode it.");
  if (task.stopped()) return fail("stopped");
  const std::filesystem::path temporary = temporary_beside(file);
  std::error_code error;
  {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(encoded.get()), length);
    out.flush();
    if (!out) {
      out.close();
      std::filesystem::remove(temporary, error);
      return fail("Cannot write " + file.string() + ": is the folder there, writable, and the disk not full?");
    }
  }
  std::filesystem::rename(temporary, file, error);
  if (!error) return {};
  const std::string reason = error.message();
  std::filesystem::remove(temporary, error);
  return fail("Cannot write " + file.string() + ": " + reason);
}

Result<Image> read_png(const std::filesystem::path& file) {
  Image image;
  int channels = 0;
  const std::unique_ptr<unsigned char, FreePixels> pixels(
      stbi_load(file.string().c_str(), &image.width, &image.height, &channels, 4));
  if (!pixels) return fail("Cannot read " + file.string() + " as PNG: " + stbi_failure_reason());
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t(image.width) * std::size_t(image.height) * 4);
  return image;
}

}  // namespace biotope
