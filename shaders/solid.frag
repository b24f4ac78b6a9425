#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "matte.glsl"
in vec3 world;
in vec3 world_normal;
out vec4 colour;

const vec3 plaster = vec3(0.46, 0.44, 0.415);

void main() { colour = matte(plaster, world, normalize(world_normal)); }
