#include "core/exchange/metric_grid.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/exchange/gdal_support.hpp"
#include "core/exchange/warp.hpp"

namespace biotope {
namespace {

/// Distances that a CRS gets wrong by more than this are reprojected. Our choice: what nobody sees in a slope.
constexpr double stretch_limit = 0.02;
/// Longest stretch of the Earth that one UTM zone can hold without bending it, degrees (our choice).
constexpr double widest_degrees = 12;
/// Cells whose sides differ by less than this part are square.
constexpr double square_tolerance = 1e-3;

using TransformationPointer = std::unique_ptr<OGRCoordinateTransformation>;

std::string rounded(double value, int decimals = 2) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

OGRSpatialReference reference_from(const std::string& wkt) {
  OGRSpatialReference reference;
  reference.importFromWkt(wkt.c_str());
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

OGRSpatialReference longitude_latitude() {
  OGRSpatialReference reference;
  reference.importFromEPSG(4326);
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

TransformationPointer transformation(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  return TransformationPointer(OGRCreateCoordinateTransformation(&from, &to));
}

std::optional<PlanePoint> moved(OGRCoordinateTransformation& transformation, PlanePoint point) {
  if (!transformation.Transform(1, &point.x, &point.y)) return std::nullopt;
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
  return point;
}

std::string wkt_of(const OGRSpatialReference& reference) {
  char* text = nullptr;
  reference.exportToWkt(&text);
  const std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

/// The UTM zone of a place, or the polar stereographic grid beyond UTM's limits (84 N, 80 S).
OGRSpatialReference local_metric_reference(PlanePoint longitude_latitude_degrees, std::string& name) {
  double longitude = std::remainder(longitude_latitude_degrees.x, 360.0);
  if (longitude >= 180) longitude -= 360;
  const double latitude = longitude_latitude_degrees.y;
  const bool north = latitude >= 0;
  OGRSpatialReference reference;
  if (latitude > 84 || latitude < -80) {
    reference.importFromEPSG(north ? 32661 : 32761);
    name = north ? "UPS North" : "UPS South";
  } else {
    const int zone = std::clamp(int(std::floor((longitude + 180) / 6)) + 1, 1, 60);
    reference.importFromEPSG((north ? 32600 : 32700) + zone);
    name = "UTM " + std::to_string(zone) + (north ? "N" : "S");
  }
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

/// The CRS's name; "UTM zone 10N (NAD27)" and the like where a format leaves it unnamed.
std::string name_of(const OGRSpatialReference& reference) {
  const std::string name = reference.GetName() == nullptr ? "" : reference.GetName();
  if (!name.empty() && name != "unnamed" && name != "unknown") return name;
  int north = 0;
  const int zone = reference.GetUTMZone(&north);
  const char* datum = reference.GetAttrValue("GEOGCS");
  if (zone == 0) return datum == nullptr ? "unnamed" : datum;
  return "UTM zone " + std::to_string(zone) + (north ? "N" : "S") + (datum == nullptr ? "" : " (" + std::string(datum) + ")");
}

double distance(PlanePoint a, PlanePoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// What a CRS makes of the grid around its centre.
struct LocalScale {
  PlanePoint longitude_latitude{};
  /// Metres of one step along a row and along a column.
  double column_metres = 0;
  double row_metres = 0;
  OGRSpatialReference metric;
  std::string metric_name;
};

std::optional<LocalScale> local_scale(const OGRSpatialReference& reference, const AffineTransform& transform, int width,
                                      int height) {
  const auto to_degrees = transformation(reference, longitude_latitude());
  if (!to_degrees) return std::nullopt;
  const PlanePoint centre{width / 2.0, height / 2.0};
  const auto place = moved(*to_degrees, apply(transform, centre));
  if (!place || std::abs(place->y) > 90.0001) return std::nullopt;
  LocalScale scale;
  scale.longitude_latitude = *place;
  scale.metric = local_metric_reference(*place, scale.metric_name);
  const auto to_metric = transformation(reference, scale.metric);
  if (!to_metric) return std::nullopt;
  const auto middle = moved(*to_metric, apply(transform, centre));
  const auto along_row = moved(*to_metric, apply(transform, {centre.x + 1, centre.y}));
  const auto along_column = moved(*to_metric, apply(transform, {centre.x, centre.y + 1}));
  if (!middle || !along_row || !along_column) return std::nullopt;
  scale.column_metres = distance(*middle, *along_row);
  scale.row_metres = distance(*middle, *along_column);
  return scale;
}

bool is_axis_aligned(const AffineTransform& t) {
  const double size = std::max({std::abs(t[1]), std::abs(t[2]), std::abs(t[4]), std::abs(t[5])});
  return std::abs(t[2]) <= 1e-6 * size && std::abs(t[4]) <= 1e-6 * size;
}

bool is_square(const AffineTransform& t) {
  return is_axis_aligned(t) && std::abs(std::abs(t[1]) - std::abs(t[5])) <= square_tolerance * std::abs(t[1]);
}

/// Turns a mirrored grid so that x grows east and row 0 is north; cells keep their values to the bit.
void orient(Grid<float>& height, AffineTransform& t) {
  if (t[1] < 0) {
    for (int y = 0; y < height.height(); ++y) std::reverse(height.row(y).begin(), height.row(y).end());
    t[0] += t[1] * height.width();
    t[1] = -t[1];
  }
  if (t[5] > 0) {
    for (int y = 0; y < height.height() / 2; ++y) {
      std::swap_ranges(height.row(y).begin(), height.row(y).end(), height.row(height.height() - 1 - y).begin());
    }
    t[3] += t[5] * height.height();
    t[5] = -t[5];
  }
}

/// Bounds of the source in the target CRS from points along its border, and the side of a cell that keeps the number of cells.
struct TargetFrame {
  double west, south, east, north, side;
};

std::optional<TargetFrame> target_frame(const AffineTransform& transform, int width, int height,
                                        OGRCoordinateTransformation* to_target) {
  constexpr int steps = 64;
  const auto at = [&](double x, double y) -> std::optional<PlanePoint> {
    const PlanePoint point = apply(transform, {x, y});
    return to_target == nullptr ? std::optional(point) : moved(*to_target, point);
  };
  constexpr double huge = std::numeric_limits<double>::infinity();
  TargetFrame frame{huge, huge, -huge, -huge, 0};
  for (int i = 0; i <= steps; ++i) {
    const double along = double(i) / steps;
    for (const auto& point : {at(along * width, 0), at(along * width, height), at(0, along * height),
                              at(width, along * height)}) {
      if (!point) return std::nullopt;
      frame.west = std::min(frame.west, point->x);
      frame.east = std::max(frame.east, point->x);
      frame.south = std::min(frame.south, point->y);
      frame.north = std::max(frame.north, point->y);
    }
  }
  const auto middle = at(width / 2.0, height / 2.0);
  const auto column = at(width / 2.0 + 1, height / 2.0);
  const auto row = at(width / 2.0, height / 2.0 + 1);
  if (!middle || !column || !row) return std::nullopt;
  frame.side = std::sqrt(std::abs((column->x - middle->x) * (row->y - middle->y) -
                                  (column->y - middle->y) * (row->x - middle->x)));
  return frame.side > 0 && std::isfinite(frame.side) ? std::optional(frame) : std::nullopt;
}

MovePoints mover(std::shared_ptr<OGRCoordinateTransformation> transformation) {
  return [transformation](std::vector<PlanePoint>& points) {
    std::vector<double> x(points.size());
    std::vector<double> y(points.size());
    std::vector<int> moved_well(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      x[i] = points[i].x;
      y[i] = points[i].y;
    }
    transformation->Transform(int(points.size()), x.data(), y.data(), nullptr, moved_well.data());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = moved_well[i] ? PlanePoint{x[i], y[i]} : PlanePoint{std::nan(""), std::nan("")};
    }
  };
}

/// Resamples on a square north-up grid in the same CRS (target null) or in `target`.
Status warp_onto(const std::filesystem::path& file, const HeightSource& source, const OGRSpatialReference* from,
                 const OGRSpatialReference* target, double metres_per_unit, MetricGrid& grid) {
  const int width = source.height.width();
  const int height = source.height.height();
  const TransformationPointer there = target ? transformation(*from, *target) : nullptr;
  const auto frame = target && !there ? std::nullopt : target_frame(*source.transform, width, height, there.get());
  if (!frame) {
    return fail(file.string() + ": its georeference cannot be turned into metres. Give --cell-size M to read the cells "
                "as they are.");
  }
  const double columns = std::max(2.0, std::round((frame->east - frame->west) / frame->side));
  const double rows = std::max(2.0, std::round((frame->north - frame->south) / frame->side));
  if (std::max(columns, rows) > largest_side * 1.5) {
    return fail(file.string() + ": would have " + rounded(columns, 0) + " x " + rounded(rows, 0) +
                " cells on a metric grid, which is too many. Take a part of it.");
  }
  WarpPlan plan;
  plan.width = int(columns);
  plan.height = int(rows);
  plan.source_transform = *source.transform;
  plan.target_transform = {frame->west, frame->side, 0, frame->north, 0, -frame->side};
  if (target) plan.to_source = mover(transformation(*target, *from));
  WarpedHeights warped = warp_heights(source.height, plan);
  if (warped.kept.width() < 2 || warped.kept.height() < 2) {
    return fail(file.string() + ": nothing is left of it on a north-up grid.");
  }
  const PlanePoint corner = apply(plan.target_transform, {double(warped.kept.x0), double(warped.kept.y0)});
  grid.height = std::move(warped.height);
  grid.cell_size = frame->side * metres_per_unit;
  grid.georeference.transform = {corner.x, frame->side, 0, corner.y, 0, -frame->side};
  grid.georeference.wkt = target ? wkt_of(*target) : source.wkt;
  return {};
}

/// Keeps square cells, or resamples oblong and turned ones in their own CRS.
Status keep_reference(const std::filesystem::path& file, HeightSource& source, const OGRSpatialReference* reference,
                      double metres_per_unit, MetricGrid& grid) {
  AffineTransform t = *source.transform;
  if (!is_square(t)) {
    grid.notes.push_back(is_axis_aligned(t) ? "Oblong cells: resampled to square ones."
                                            : "The grid is turned: resampled with north up, its corners cut off.");
    return warp_onto(file, source, reference, nullptr, metres_per_unit, grid);
  }
  orient(source.height, t);
  grid.height = std::move(source.height);
  grid.georeference = {source.wkt, t};
  grid.cell_size = std::abs(t[1]) * metres_per_unit;
  return {};
}

void use_cell_size(HeightSource& source, double cell_size, MetricGrid& grid) {
  grid.height = std::move(source.height);
  grid.cell_size = cell_size;
  grid.georeference.transform = {0, cell_size, 0, grid.height.height() * cell_size, 0, -cell_size};
}

Status place_without_crs(const std::filesystem::path& file, HeightSource& source, MetricGrid& grid) {
  const AffineTransform& t = *source.transform;
  const double size = std::hypot(t[1], t[4]);
  if (size < 0.05) {
    return fail(file.string() + ": has no coordinate system, and its pixel size of " + rounded(size, 6) +
                " looks like degrees. Give the size of a cell in metres: --cell-size M.");
  }
  grid.notes.push_back("No coordinate system: the pixel size of " + rounded(size) +
                       " is taken as metres; latitude 42.85 is assumed.");
  return keep_reference(file, source, nullptr, 1, grid);
}

Status place_with_crs(const std::filesystem::path& file, HeightSource& source, const OGRSpatialReference& reference,
                      MetricGrid& grid) {
  const int width = source.height.width();
  const int height = source.height.height();
  const auto scale = local_scale(reference, *source.transform, width, height);
  if (scale) grid.latitude = std::clamp(scale->longitude_latitude.y, -90.0, 90.0);
  const double metres_per_unit = grid.geographic ? 1 : reference.GetLinearUnits();
  if (!scale) {
    if (grid.geographic) {
      return fail(file.string() + ": its coordinates are not degrees on the Earth. Give --cell-size M to read the "
                  "cells as they are.");
    }
    return keep_reference(file, source, &reference, metres_per_unit, grid);
  }
  const AffineTransform& t = *source.transform;
  const double column_stretch = std::hypot(t[1], t[4]) * metres_per_unit / scale->column_metres;
  const double row_stretch = std::hypot(t[2], t[5]) * metres_per_unit / scale->row_metres;
  const bool true_to_scale =
      std::abs(column_stretch - 1) <= stretch_limit && std::abs(row_stretch - 1) <= stretch_limit;
  if (!grid.geographic && true_to_scale) {
    if (metres_per_unit != 1) grid.notes.push_back("Coordinates in feet: cells are converted to metres.");
    return keep_reference(file, source, &reference, metres_per_unit, grid);
  }
  const double degrees_wide = std::hypot(t[1], t[2]) * width * (grid.geographic ? 1 : metres_per_unit / 111320);
  const double degrees_high = std::hypot(t[4], t[5]) * height * (grid.geographic ? 1 : metres_per_unit / 111320);
  if (std::max(degrees_wide, degrees_high) > widest_degrees) {
    return fail(file.string() + ": covers about " + rounded(degrees_wide, 0) + " x " + rounded(degrees_high, 0) +
                " degrees, too much of the Earth for one flat map. Take a part of it, for example with gdal_translate "
                "-projwin.");
  }
  grid.notes.push_back((grid.geographic ? "Degrees: reprojected to " : "The map projection stretches distances: reprojected to ") +
                       scale->metric_name + ".");
  return warp_onto(file, source, &reference, &scale->metric, 1, grid);
}

}  // namespace

Result<MetricGrid> place_on_metric_grid(const std::filesystem::path& file, HeightSource& source,
                                        std::optional<double> cell_size) {
  const GdalErrorScope errors;
  MetricGrid grid;
  const OGRSpatialReference reference = reference_from(source.wkt);
  const bool known = !source.wkt.empty() && (reference.IsProjected() || reference.IsGeographic());
  if (known) {
    grid.crs_name = name_of(reference);
    grid.geographic = reference.IsGeographic();
  }
  if (source.transform) {
    const AffineTransform& t = *source.transform;
    const double determinant = t[1] * t[5] - t[2] * t[4];
    if (!std::isfinite(determinant) || determinant == 0) source.transform.reset();
  }
  Status placed;
  if (cell_size) {
    if (known && source.transform) {
      const auto scale = local_scale(reference, *source.transform, source.height.width(), source.height.height());
      if (scale) grid.latitude = scale->longitude_latitude.y;
      grid.notes.push_back("The given cell size overrules the file's georeference.");
    }
    use_cell_size(source, *cell_size, grid);
  } else if (!source.transform) {
    grid.notes.push_back("No georeference: the size of a cell must be given.");
    grid.height = std::move(source.height);
  } else if (known) {
    placed = place_with_crs(file, source, reference, grid);
  } else {
    placed = place_without_crs(file, source, grid);
  }
  if (!placed) return tl::unexpected(placed.error());
  return grid;
}

}  // namespace biotope
