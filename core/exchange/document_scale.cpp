#include "core/exchange/document_scale.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/exchange/dem_import.hpp"
#include "core/exchange/resample.hpp"

namespace biotope {
namespace {

/// Values are weighted by their coverage, so that unpainted cells lend no colour to their neighbours.
std::shared_ptr<const PaintLayer> resampled_layer(const PaintLayer& layer, double ratio, int width, int height) {
  Grid<float> weighted(layer.width(), layer.height());
  Grid<float> coverage(layer.width(), layer.height());
  parallel_rows(0, layer.height(), [&](int y) {
    std::vector<Paint> row(std::size_t(layer.width()));
    layer.read_row(y, 0, row);
    for (int x = 0; x < layer.width(); ++x) {
      const Paint paint = row[std::size_t(x)];
      weighted(x, y) = paint.value * paint.coverage;
      coverage(x, y) = paint.coverage;
    }
  });
  weighted = resampled_grid(weighted, ratio, width, height);
  coverage = resampled_grid(coverage, ratio, width, height);
  auto result = std::make_shared<PaintLayer>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (coverage(x, y) > 0) result->set(x, y, {weighted(x, y) / coverage(x, y), coverage(x, y)});
    }
  }
  return result;
}

std::shared_ptr<const Grid<Geology>> resampled_geology(const Grid<Geology>& geology, double ratio, int width,
                                                       int height) {
  auto result = std::make_shared<Grid<Geology>>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      (*result)(x, y) = geology.clamped(int((x + 0.5) * ratio), int((y + 0.5) * ratio));
    }
  }
  return result;
}

}  // namespace

Document resampled_document(const Document& document, int longer_side) {
  const Terrain& source = *document.terrain;
  const int source_longer = std::max(source.height.width(), source.height.height());
  if (longer_side == source_longer) return document;
  const double ratio = double(source_longer) / longer_side;
  Document result = document;
  auto terrain = std::make_shared<Terrain>(resampled(source, longer_side));
  const int width = terrain->height.width();
  const int height = terrain->height.height();
  result.terrain = std::move(terrain);
  for (Inflow& inflow : result.inflows) {
    inflow.x = std::clamp(int((inflow.x + 0.5) / ratio), 0, width - 1);
    inflow.y = std::clamp(int((inflow.y + 0.5) / ratio), 0, height - 1);
  }
  for (auto& [id, layer] : result.layers) layer = resampled_layer(*layer, ratio, width, height);
  for (auto& maps : result.given_environment.monthly) {
    for (auto& map : maps) map = std::make_shared<Grid<float>>(resampled_grid(*map, ratio, width, height));
  }
  auto& geology = result.given_environment.geology;
  if (geology) geology = resampled_geology(*geology, ratio, width, height);
  return result;
}

Document with_cell_size(const Document& document, double cell_size) {
  Document result = document;
  auto terrain = std::make_shared<Terrain>(*document.terrain);
  const double ratio = cell_size / terrain->cell_size;
  terrain->cell_size = cell_size;
  terrain->georeference.wkt.clear();
  terrain->georeference.transform = {0, cell_size, 0, terrain->height.height() * cell_size, 0, -cell_size};
  for (Inflow& inflow : result.inflows) inflow.catchment_area *= ratio * ratio;
  result.terrain = std::move(terrain);
  return result;
}

}  // namespace biotope
