#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;  // of the unit sphere
layout(location = 3) in vec4 instance;  // centre, radius

out vec3 world;
out vec3 world_normal;

void main() {
    world = instance.xyz + instance.w * position;
    world_normal = position;
    gl_Position = view_projection * vec4(world, 1.0);
}
