#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "hard.glsl"
in vec3 world;
in vec3 world_normal;
out vec4 colour;

// Brushed steel
void main() { colour = hard(vec3(0.30, 0.29, 0.28), 1.0, world, normalize(world_normal), vec3(0.0)); }
