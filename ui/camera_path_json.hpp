#pragma once

#include <string>

#include "core/climate/json_reader.hpp"
#include "ui/camera_path.hpp"

namespace biotope {

// Cameras and paths as parts of JSON.

[[nodiscard]] Json path_to_json(const CameraPath& path);
/// At least two keys are wanted where `whole`. A member of a name that is not known is an Error; where `unknown` is given it is
/// left out instead, and what was wrong is noted there unless something was before.
[[nodiscard]] Result<CameraPath> parse_path(const Json& json, const std::string& origin, bool whole,
                                            std::string* unknown = nullptr);

/// A camera as members of an object, and back.
void write_camera(Json& json, const Camera& camera);
void read_camera(JsonReader& reader, Camera& camera);

}  // namespace biotope
