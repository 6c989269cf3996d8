#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/ground.glsl"
#include "landscape/clouds.glsl"
#include "landscape/shade.glsl"
#include "landscape/snow.glsl"
const bool with_fur = false;
#include "landscape/animal_coat.glsl"
