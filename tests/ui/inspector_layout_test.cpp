#include "ui/inspector_layout.hpp"

#include <catch2/catch.hpp>

#include <numeric>

using namespace biotope;

namespace {

InspectorState with(bool why, bool herd, bool brush) {
  InspectorState state;
  follow_cards(state, {why, herd, brush}, {});
  return state;
}

float sum_of(const InspectorLayout& layout) { return std::accumulate(layout.card.begin(), layout.card.end(), layout.list); }

}  // namespace

TEST_CASE("without cards the list has all the room") {
  const InspectorLayout layout = lay_out_inspector(with(false, false, false), 600, 200, 26);
  CHECK(layout.list == 600);
  CHECK_FALSE(layout.tabs);
}

TEST_CASE("where there is room every card is as high as its content") {
  const InspectorState state = with(true, true, true);
  const InspectorLayout layout = lay_out_inspector(state, 1200, 200, 26);
  CHECK_FALSE(layout.tabs);
  CHECK(layout.card == state.content);
  CHECK(sum_of(layout) == Approx(1200));
}

TEST_CASE("where there is not, one card is shown under tabs, and the list keeps its lines") {
  const InspectorState state = with(true, true, false);
  const InspectorLayout layout = lay_out_inspector(state, 600, 160, 26);
  CHECK(layout.tabs);
  CHECK(layout.card[std::size_t(InspectorCard::herd)] == state.content[std::size_t(InspectorCard::herd)]);
  CHECK(layout.card[std::size_t(InspectorCard::why)] == 0);
  CHECK(layout.list >= 160);
  CHECK(sum_of(layout) + 26 == Approx(600));
}

TEST_CASE("the tabs stay where they are, whichever card is in front") {
  InspectorState state = with(true, true, true);
  const InspectorLayout brush = lay_out_inspector(state, 700, 200, 26);
  state.front = InspectorCard::why;
  const InspectorLayout why = lay_out_inspector(state, 700, 200, 26);
  REQUIRE(brush.tabs);
  CHECK(why.list == brush.list);
}

TEST_CASE("however little room there is, no part is negative and together they fit") {
  for (float room = 0; room < 1500; room += 37) {
    for (int cards = 0; cards < 8; ++cards) {
      const InspectorLayout layout = lay_out_inspector(with((cards & 1) != 0, (cards & 2) != 0, (cards & 4) != 0), room, 180, 26);
      CHECK(layout.list >= 0);
      for (const float card : layout.card) CHECK(card >= 0);
      const float tabs = layout.tabs ? 26.0F : 0.0F;
      CHECK(sum_of(layout) + tabs <= std::max(room, tabs) + 0.01F);
      if (room > 200) CHECK(layout.list >= std::min(180.0F, 0.36F * room) - 0.01F);
    }
  }
}

TEST_CASE("the card that came last, or is about something new, is in front, and one that goes leaves it to another") {
  InspectorState state = with(true, false, true);
  follow_cards(state, {true, true, true}, {});
  CHECK(state.front == InspectorCard::herd);
  follow_cards(state, {true, true, true}, {true, false, false});
  CHECK(state.front == InspectorCard::why);
  follow_cards(state, {true, true, true}, {});
  CHECK(state.front == InspectorCard::why);
  follow_cards(state, {false, true, true}, {});
  CHECK(state.front == InspectorCard::herd);
}
