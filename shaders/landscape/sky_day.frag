#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
const bool with_stars = false;
const bool with_lit_clouds = true;
#include "landscape/sky_view.glsl"
