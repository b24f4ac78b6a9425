#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "studio.glsl"
in vec3 world;
out vec4 colour;

void main() { colour = studio(world, true, key_visibility(world, vec3(0.0, 1.0, 0.0))); }
