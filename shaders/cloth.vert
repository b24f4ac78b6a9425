#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 5) in vec4 place_and_extent;
layout(location = 6) in float value;
layout(location = 7) in float hollow;

out vec3 world;
out vec3 world_normal;
out vec2 place;        // in the cloth, laid out flat [m]
flat out vec2 extent;  // of all the cloth [m]
out float hollow_front;  // how deep in a fold of the front, in [-1, 1]
out float vertex_value;
flat out float cell_value;

void main() {
    world = position;
    world_normal = normal;
    place = place_and_extent.xy;
    extent = place_and_extent.zw;
    hollow_front = hollow;
    vertex_value = value;
    cell_value = value;
    gl_Position = view_projection * vec4(world, 1.0);
}
