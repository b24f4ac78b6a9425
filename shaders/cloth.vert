#version 330 core
#include "frame.glsl"
#include "cover.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 5) in vec4 place_and_extent;
layout(location = 6) in float value;
layout(location = 7) in float hollow;
layout(location = 9) in float number;

out vec3 world;
out vec3 world_normal;
out vec2 place;        // in the cloth, laid out flat [m]
flat out vec2 extent;  // of all the cloth [m]
flat out vec3 front_colour;
flat out vec3 back_colour;
out float hollow_front;  // how deep in a fold of the front, in [-1, 1]
out vec3 cover;
out float vertex_value;
flat out float cell_value;

// Front and back of four cloths, in each palette
const vec3 colours[24] = vec3[](
    vec3(0.72, 0.105, 0.06), vec3(0.04, 0.24, 0.265), vec3(0.80, 0.44, 0.09), vec3(0.20, 0.065, 0.15),
    vec3(0.075, 0.20, 0.45), vec3(0.62, 0.47, 0.30), vec3(0.17, 0.33, 0.12), vec3(0.30, 0.16, 0.08),

    vec3(0.84, 0.47, 0.08), vec3(0.16, 0.06, 0.20), vec3(0.62, 0.10, 0.14), vec3(0.05, 0.15, 0.19),
    vec3(0.06, 0.36, 0.36), vec3(0.46, 0.30, 0.16), vec3(0.66, 0.60, 0.50), vec3(0.12, 0.10, 0.22),

    vec3(0.055, 0.105, 0.31), vec3(0.60, 0.52, 0.39), vec3(0.66, 0.55, 0.40), vec3(0.24, 0.17, 0.10),
    vec3(0.52, 0.13, 0.09), vec3(0.16, 0.20, 0.22), vec3(0.24, 0.33, 0.25), vec3(0.50, 0.42, 0.24));

void main() {
    world = position;
    world_normal = normal;
    place = place_and_extent.xy;
    extent = place_and_extent.zw;
    int first = 8 * style.y + 2 * (int(number + 0.5) % 4);
    front_colour = colours[first];
    back_colour = colours[first + 1];
    hollow_front = hollow;
    cover = cover_of(position, normal, 0.07);
    vertex_value = value;
    cell_value = value;
    gl_Position = view_projection * vec4(world, 1.0);
}
