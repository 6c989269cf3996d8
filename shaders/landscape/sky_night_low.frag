#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
const bool with_stars = true;
const bool with_lit_clouds = false;
#include "landscape/sky_view.glsl"
