#pragma once

#include <memory>
#include <vector>

#include "render/background_maker.hpp"
#include "render/map_lines.hpp"
#include "render/mipmaps.hpp"

namespace biotope {

/// What the ground of the 2D map is made from; parts that are not known yet are null.
struct MapRequest {
  std::shared_ptr<const Terrain> terrain;
  std::shared_ptr<const Hydrology> hydrology;
  std::shared_ptr<const TrailNetwork> trails;
  bool operator==(const MapRequest&) const = default;
};

/// Heights and shaded relief.
struct MapRelief {
  int stride = 1;       ///< cells a texel
  Grid<float> thinned;  ///< heights when stride is above 1; else they are the terrain's own
  std::vector<Grid<float>> height_mipmaps;
  Grid<Rgba> relief;  ///< a muted tint by height, and the shade: one half on flat ground
  std::vector<Grid<Rgba>> relief_mipmaps;
};

/// Wet cells (first) and their depth on a square-root scale (second), and rivers.
struct MapWater {
  Grid<Rg> wet;
  std::vector<Grid<Rg>> wet_mipmaps;
  RibbonMesh rivers;
};

/// The 2D map's ground, ready for upload. Immutable; pictures share parts that are alike.
struct MapPicture {
  MapRequest of;
  std::shared_ptr<const MapRelief> relief;
  std::shared_ptr<const MapWater> water;
  std::shared_ptr<const RibbonMesh> trails;

  [[nodiscard]] const Grid<float>& heights() const { return relief->stride > 1 ? relief->thinned : of.terrain->height; }
};

/// The relief of every `stride`-th cell. Parallel.
[[nodiscard]] std::shared_ptr<const MapRelief> shaded_relief(const Terrain& terrain, int stride);

/// Makes pictures of the map's ground in the background; another terrain comes as a coarse picture first.
class MapMaker {
 public:
  MapMaker();
  void request(MapRequest request);
  [[nodiscard]] std::shared_ptr<const MapPicture> take() { return maker_.take(); }
  [[nodiscard]] bool busy() const { return maker_.busy(); }
  void wait_idle() { maker_.wait_idle(); }
  void retire(std::shared_ptr<const MapPicture> old) { maker_.retire(std::move(old)); }

 private:
  using Maker = BackgroundMaker<MapRequest, MapPicture>;
  void make(const MapRequest& request, const std::stop_token& outdated, const Maker::Publish& publish);

  std::shared_ptr<const Terrain> asked_;    ///< of the asking thread
  std::shared_ptr<const MapPicture> last_;  ///< of the working thread
  Maker maker_;
};

}  // namespace biotope
