#include "ui/brush_ring.hpp"

#include <catch2/catch.hpp>

#include "ui/editor_state.hpp"

using namespace biotope;

TEST_CASE(
    "the brush's ring is on the ground of the 3D view wherever the pointer is, and on the map while it is over the 3D view") {
  EditorState state;
  state.brush.radius = 12;
  state.tool = Tool::add;
  CHECK_FALSE(ring_in_landscape(state));
  CHECK_FALSE(ring_on_map(state, false));

  // Over the map, which draws it itself.
  state.pointer = {true, 40, 30};
  CHECK(ring_in_landscape(state) == glm::vec3(40, 30, 12));
  CHECK_FALSE(ring_on_map(state, true));

  // Over the 3D view: both tell the place under the pointer.
  state.pointer = {true, 7, 9};
  state.exploring.pointer = PathPoint{7, 9};
  CHECK(ring_in_landscape(state) == glm::vec3(7, 9, 12));
  REQUIRE(ring_on_map(state, false));
  CHECK(ring_on_map(state, false)->x == 7);
  CHECK(ring_on_map(state, false)->y == 9);

  // With a tool that is no brush there is none.
  state.tool = Tool::select;
  CHECK_FALSE(ring_in_landscape(state));
  CHECK_FALSE(ring_on_map(state, false));
}
