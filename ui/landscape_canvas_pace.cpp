#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/landscape_canvas.hpp"

// When a picture is drawn, and how coarse: so that the window keeps its pace where a picture takes long.

namespace biotope {
namespace {

constexpr double wanted_seconds = 1.0 / 24;  // of a moving picture; map and window take their share of the frame too
constexpr double coarsest = 0.4;             // share of the resolution below which one no longer sees what is there
constexpr double longest_wait = 0.4;         // s for which frames follow each other while an edit is being answered
constexpr double rest_seconds = 0.25;        // after which the picture is drawn sharp
constexpr double slow_seconds = 0.03;        // a picture that takes longer is put off while an edit is being answered,
constexpr double longest_put_off = 0.1;      // so long at most, s, and no longer than it takes itself

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.heading == b.heading && a.pitch == b.pitch && a.vertical_field == b.vertical_field;
}

bool same_options(const LandscapeOptions& a, const LandscapeOptions& b) {
  return a.hour == b.hour && a.month == b.month && a.plants == b.plants && a.animals == b.animals && a.trails == b.trails &&
         a.water == b.water && a.quality == b.quality && a.weather == b.weather && a.seconds == b.seconds &&
         a.visible_species == b.visible_species && a.brush == b.brush;
}

}  // namespace

std::optional<double> LandscapeCanvas::resolution_now(const EditorState& state, const Picture& wanted, bool news) {
  const double now = ImGui::GetTime();
  const bool same_size = has_picture_ && wanted.width == drawn_.width && wanted.height == drawn_.height;
  const bool same = same_size && !news && same_camera(wanted.camera, drawn_.camera) &&
                    same_options(wanted.options, drawn_.options) && wanted.snapshot == drawn_.snapshot;
  if (!same) last_change_ = now;
  // Plants that are still being built come in quickly on a coarse picture; the sharp one follows.
  const bool complete = has_picture_ && renderer_->complete();
  const bool resting = now - last_change_ > rest_seconds && complete;
  const double resolution = software_ && !resting ? resolution_ : 1.0;
  refining_ = (software_ && !resting && resolution < 1) || !complete;
  measures_now_ = measuring_ && complete && state.shown->complete;
  if (same && drawn_resolution_ >= resolution && !measures_now_) return std::nullopt;
  if (same_size && waits_for_edit(wanted, now)) {
    refining_ = true;
    return std::nullopt;
  }
  // A picture that takes long even when it is coarse is drawn less often, so that the rest of the window keeps its pace; but what
  // answers an edit is shown at once.
  const bool answers =
      same_size && wanted.snapshot->document_revision >= awaited_ && drawn_.snapshot->document_revision < awaited_;
  const bool moves_slowly = software_ && same_size && !resting && !answers;
  if (moves_slowly && now - drawn_at_ < 1.5 * drawn_seconds_) {
    refining_ = true;
    return std::nullopt;
  }
  return resolution;
}

bool LandscapeCanvas::waits_for_edit(const Picture& wanted, double now) {
  const bool coming = awaiting_ || (!renderer_->all_made() && drawn_.snapshot->document_revision < awaited_);
  const bool put_off = software_ && drawn_seconds_ > slow_seconds && coming && same_camera(wanted.camera, drawn_.camera);
  if (!put_off) {
    waits_since_ = -1;
    return false;
  }
  if (waits_since_ < 0) waits_since_ = now;
  return now - waits_since_ < std::min(drawn_seconds_, longest_put_off);
}

void LandscapeCanvas::learn_from(double seconds, double resolution) {
  // A coarse picture counts as a full one of as many pixels.
  if (measures_now_) measured_seconds_.push_back(seconds / (resolution * resolution));
  refining_ = refining_ || measuring_;
  if (software_) {
    // What a full picture costs tells how coarse a moving one must be; half-way steps keep it from flickering.
    const double fitting = resolution * std::sqrt(wanted_seconds / std::max(seconds, 1e-4));
    resolution_ = std::clamp(0.5 * resolution_ + 0.5 * fitting, coarsest, 1.0);
  }
  drawn_seconds_ = software_ || measures_now_ ? seconds : 0;
}

void LandscapeCanvas::await_answer(const EditorState& state, const MapsSnapshot& wanted) {
  const double now = ImGui::GetTime();
  if (std::exchange(awaited_, state.posted_revision) != state.posted_revision) awaited_since_ = now;
  awaiting_ = wanted.document_revision < awaited_ && now - awaited_since_ < longest_wait;
}

}  // namespace biotope
