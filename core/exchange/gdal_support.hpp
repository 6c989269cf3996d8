#pragma once

#include <cpl_error.h>
#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>

namespace biotope {

/// Registers GDAL's raster drivers, once however often it is called.
void register_gdal_drivers();

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(GDALDataset::ToHandle(dataset)); }
};
/// An open GDAL dataset, closed with its owner.
using DatasetPointer = std::unique_ptr<GDALDataset, DatasetCloser>;

/// While it lives, what GDAL has to say on this thread is kept here instead of being printed, and GDAL writes no side files.
class GdalErrorScope {
 public:
  GdalErrorScope();
  ~GdalErrorScope();
  GdalErrorScope(const GdalErrorScope&) = delete;
  GdalErrorScope& operator=(const GdalErrorScope&) = delete;

  /// True after an error; warnings do not count.
  [[nodiscard]] bool failed() const { return failed_; }
  /// GDAL's first error in one line; empty when there was none.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum number, const char* text);
  bool failed_ = false;
  std::string message_;
};

/// Opens a raster for reading; null when no driver can.
[[nodiscard]] DatasetPointer open_raster(const std::filesystem::path& file);

/// `: what GDAL said`, or nothing when it said nothing. For the end of a message.
[[nodiscard]] std::string because(const GdalErrorScope& errors);

}  // namespace biotope
