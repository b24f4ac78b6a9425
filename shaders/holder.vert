#version 330 core
#include "frame.glsl"
#include "holder.glsl"
out vec3 world;
out vec3 world_normal;

void main() {
    TubePoint point = tube_point();
    world = point.world;
    world_normal = point.normal;
    gl_Position = view_projection * vec4(world, 1.0);
}
