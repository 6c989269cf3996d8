#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/ground.glsl"
const bool with_water = true;
const bool with_canopy = true;
#include "landscape/terrain_surface.glsl"
