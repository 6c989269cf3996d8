#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
const bool posed = false;
#include "landscape/animal_rig.glsl"
