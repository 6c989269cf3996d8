#include "core/exchange/gdal_support.hpp"

#include <algorithm>
#include <mutex>

namespace biotope {

void register_gdal_drivers() {
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

GdalErrorScope::GdalErrorScope() {
  CPLPushErrorHandlerEx(&GdalErrorScope::keep, this);
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
}

GdalErrorScope::~GdalErrorScope() {
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
  CPLPopErrorHandler();
}

void CPL_STDCALL GdalErrorScope::keep(CPLErr severity, CPLErrorNum, const char* text) {
  auto* scope = static_cast<GdalErrorScope*>(CPLGetErrorHandlerUserData());
  if (scope == nullptr || severity < CE_Failure || scope->failed_) return;
  scope->failed_ = true;
  scope->message_ = text == nullptr ? "" : text;
  std::replace(scope->message_.begin(), scope->message_.end(), '\n', ' ');
}

DatasetPointer open_raster(const std::filesystem::path& file) {
  register_gdal_drivers();
  return DatasetPointer(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
}

std::string because(const GdalErrorScope& errors) {
  return errors.message().empty() ? std::string() : " (" + errors.message() + ")";
}

}  // namespace biotope
