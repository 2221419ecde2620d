#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Disk and hemisphere, of points in memory.
#include "interface.glsl"
#include "map_hemisphere.glsl"
#include "map_main.glsl"
