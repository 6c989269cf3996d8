#include "ui/inspector_layout.hpp"

#include <algorithm>
#include <cstddef>

namespace biotope {
namespace {

constexpr float least_share = 0.36F;  // of the room that the list keeps where that is less than it should have

}  // namespace

void follow_cards(InspectorState& state, const std::array<bool, inspector_cards>& present,
                  const std::array<bool, inspector_cards>& renewed) {
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i] && (!state.present[i] || renewed[i])) state.front = InspectorCard(i);
  }
  state.present = present;
  if (present[std::size_t(state.front)]) return;
  const auto first = std::find(present.begin(), present.end(), true);
  if (first != present.end()) state.front = InspectorCard(first - present.begin());
}

InspectorLayout lay_out_inspector(const InspectorState& state, float room, float least_list, float tab_height) {
  InspectorLayout layout;
  const float list = std::min(least_list, least_share * room);
  float wanted = 0;
  float highest = 0;
  int count = 0;
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    if (!state.present[i]) continue;
    wanted += state.content[i];
    highest = std::max(highest, state.content[i]);
    ++count;
  }
  if (wanted <= room - std::max(list, least_list) || count <= 1) {
    for (std::size_t i = 0; i < state.present.size(); ++i) {
      if (state.present[i]) layout.card[i] = std::max(std::min(state.content[i], room - list), 0.0F);
      layout.list -= layout.card[i];
    }
    layout.list += room;
    return layout;
  }
  layout.tabs = true;
  // As high for every card, so that the tabs stay under the pointer.
  const float card = std::max(std::min(highest, room - list - tab_height), 0.0F);
  layout.card[std::size_t(state.front)] = card;
  layout.list = std::max(room - tab_height - card, 0.0F);
  return layout;
}

}  // namespace biotope
