#pragma once

#include <string>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/document/selection.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// GeoTIFF files in memory, as scenes hold them. Bytes are the same for the same cells; nothing is rounded.
[[nodiscard]] Result<std::string> encode_floats(const Grid<float>& cells, const Georeference& georeference);
[[nodiscard]] Result<std::string> encode_bytes(const Grid<std::uint8_t>& cells);
/// Two bands, value and coverage; blocks that nobody painted take no room.
[[nodiscard]] Result<std::string> encode_paint(const PaintLayer& layer);
/// One band of bytes; blank blocks take no room.
[[nodiscard]] Result<std::string> encode_selection(const SelectionMask& mask);

/// The way back. `what` names the file in messages; any other size, band count or format than expected is an Error.
[[nodiscard]] Result<Grid<float>> decode_floats(const std::string& bytes, int width, int height, const std::string& what);
[[nodiscard]] Result<Grid<std::uint8_t>> decode_bytes(const std::string& bytes, int width, int height, const std::string& what);
[[nodiscard]] Result<PaintLayer> decode_paint(const std::string& bytes, int width, int height, const std::string& what);
[[nodiscard]] Result<SelectionMask> decode_selection(const std::string& bytes, int width, int height, const std::string& what);

}  // namespace biotope
