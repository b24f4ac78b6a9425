#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 world;
out vec3 world_normal;

void main() {
    world = position;
    world_normal = normal;
    gl_Position = view_projection * vec4(world, 1.0);
}
