// Two thirds of the sources in ui include this header of ours, and it most of the model: parsing it took them longer than all the
// rest.
#pragma once

#include "cmake/precompiled/standard.hpp"
#include "ui/editor_state.hpp"
