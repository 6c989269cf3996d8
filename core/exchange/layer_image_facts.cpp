#include "core/exchange/gdal_support.hpp"
#include "core/exchange/height_source.hpp"
#include "core/exchange/layer_image.hpp"

namespace biotope {

Result<ImageFacts> look_at_image(const std::filesystem::path& file) {
  if (const Status readable = check_readable(file); !readable) return tl::unexpected(readable.error());
  const GdalErrorScope errors;
  const DatasetPointer dataset = open_raster(file);
  if (!dataset || dataset->GetRasterCount() < 1)
    return fail(file.string() + ": is no image that can be read" + because(errors) + ".");
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  const GDALDataType type = band.GetRasterDataType();
  ImageFacts facts;
  facts.width = dataset->GetRasterXSize();
  facts.height = dataset->GetRasterYSize();
  facts.picture = type == GDT_Byte || type == GDT_UInt16 || band.GetColorTable() != nullptr;
  facts.white = type == GDT_UInt16 ? 65535.0F : 255.0F;
  facts.grey = dataset->GetRasterCount() < 3 && band.GetColorTable() == nullptr;
  return facts;
}

}  // namespace biotope
