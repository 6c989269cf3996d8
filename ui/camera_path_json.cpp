#include "ui/camera_path_json.hpp"

#include <cmath>

namespace biotope {
namespace {

constexpr Limits place_limits{-1e9, 1e9};  // beyond the largest terrains
constexpr Limits degree_limits{-360, 360};
constexpr Limits pitch_limits{-90, 90};
constexpr Limits field_limits{5, 120};
constexpr double least_between_keys = 0.0085;  // s; keys are 0.01 s apart, and are written rounded to a thousandth

}  // namespace

void write_camera(Json& json, const Camera& camera) {
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  json["x"] = rounded(camera.position.x);
  json["y"] = rounded(camera.position.y);
  json["z"] = rounded(camera.position.z);
  json["heading"] = tidy_number(std::fmod(camera.heading, 360.0F));
  json["pitch"] = tidy_number(camera.pitch);
  json["field"] = tidy_number(camera.vertical_field);
}

void read_camera(JsonReader& reader, Camera& camera) {
  reader.number("x", camera.position.x, place_limits, Presence::required);
  reader.number("y", camera.position.y, place_limits, Presence::required);
  reader.number("z", camera.position.z, place_limits, Presence::required);
  reader.number("heading", camera.heading, degree_limits, Presence::required);
  reader.number("pitch", camera.pitch, pitch_limits, Presence::required);
  reader.number("field", camera.vertical_field, field_limits);
}

Json path_to_json(const CameraPath& path) {
  Json json = Json::object();
  Json keys = Json::array();
  for (const CameraKey& key : path.keys) {
    Json one = Json::object();
    one["seconds"] = std::round(key.seconds * 1000) / 1000;
    write_camera(one, key.camera);
    keys.push_back(std::move(one));
  }
  json["keys"] = std::move(keys);
  if (path.hours) json["hours"] = *path.hours;
  return json;
}

namespace {

/// Refuses unknown keys, or notes the first of them.
void finish(JsonReader& reader, std::string& problem, std::string* unknown) {
  if (!problem.empty()) return;
  reader.finish();
  if (unknown == nullptr) return;
  if (unknown->empty()) *unknown = problem;
  problem.clear();
}

}  // namespace

Result<CameraPath> parse_path(const Json& json, const std::string& origin, bool whole, std::string* unknown) {
  CameraPath path;
  std::string problem;
  JsonReader reader(json, origin, problem);
  const Json* keys = reader.value("keys", Presence::required, "a list of views");
  if (keys != nullptr && (!keys->is_array() || keys->size() > most_path_keys)) {
    reader.refuse("keys", "a list of at most " + std::to_string(most_path_keys) + " views", *keys);
    keys = nullptr;
  }
  if (keys != nullptr) {
    for (std::size_t i = 0; i < keys->size() && reader.ok(); ++i) {
      JsonReader one((*keys)[i], origin + ": key " + std::to_string(i + 1), problem);
      CameraKey key;
      one.number("seconds", key.seconds, {0, longest_path}, Presence::required);
      read_camera(one, key.camera);
      finish(one, problem, unknown);
      if (problem.empty() && !path.keys.empty() && key.seconds < path.keys.back().seconds + least_between_keys) {
        problem = origin + ": key " + std::to_string(i + 1) + ": \"seconds\" must be more than those of the key before";
      }
      path.keys.push_back(key);
    }
  }
  if (reader.value("hours", Presence::optional, "two hours") != nullptr) {
    std::array<double, 2> hours{};
    reader.numbers("hours", hours, {0, 24});
    path.hours = hours;
  }
  finish(reader, problem, unknown);
  if (problem.empty() && whole && path.keys.size() < 2) problem = origin + ": \"keys\" must have at least two views";
  if (!problem.empty()) return fail(problem + ".");
  return path;
}

std::string path_to_text(const CameraPath& path) { return path_to_json(path).dump(1) + "\n"; }

Result<CameraPath> parse_path_text(std::string_view text, const std::string& origin) {
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  return parse_path(*json, origin, true);
}

}  // namespace biotope
