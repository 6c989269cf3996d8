#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/ground.glsl"
#include "landscape/shade.glsl"
#include "landscape/snow.glsl"
const bool with_water = true;
const bool with_canopy = true;
const bool with_detail = true;
#include "landscape/plant_dither.glsl"
#include "landscape/water.glsl"
#include "landscape/ford.glsl"
#include "landscape/plant_canopy.glsl"
#include "landscape/litter.glsl"
#include "landscape/terrain_surface.glsl"
