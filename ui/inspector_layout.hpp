#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace biotope {

/// What may lie under the list of the inspector.
enum class InspectorCard : std::uint8_t { why, herd, brush };
inline constexpr int inspector_cards = 3;

/// Which cards are there and which one is in front where there is not room for all of them.
struct InspectorState {
  InspectorCard front = InspectorCard::brush;
  std::array<bool, inspector_cards> present{};
  /// What their contents took when they were drawn last, pixels.
  std::array<float, inspector_cards> content{160, 360, 240};
};

/// Takes note of which cards are there now; one that has just come, or is about something else than before, comes to the front.
void follow_cards(InspectorState& state, const std::array<bool, inspector_cards>& present,
                  const std::array<bool, inspector_cards>& renewed);

/// Heights of the inspector's parts, pixels.
struct InspectorLayout {
  float list = 0;
  std::array<float, inspector_cards> card{};
  /// Only the front card is shown, under tabs with the names of all.
  bool tabs = false;
};

/// Divides `room` pixels: every card as high as its content where the list keeps `least_list`; else one card at a time under tabs
/// of `tab_height`, scrolled where it is higher than what the list leaves.
[[nodiscard]] InspectorLayout lay_out_inspector(const InspectorState& state, float room, float least_list, float tab_height);

}  // namespace biotope
