#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "fabric.glsl"
in vec3 world;
in vec3 world_normal;
in float hollow_front;
in float vertex_value;
flat in float cell_value;
out vec4 colour;

vec3 value_colour(float value) {
    float position = clamp(value, 0.0, 1.0) * 8.0;
    int first = min(int(position), 7);
    return mix(value_colours[first].rgb, value_colours[first + 1].rgb, position - float(first));
}

// As the legend shows it, in a light that is half as strong as usual and half the same everywhere
void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 shown = value_colour(vertex_value);
    if (look.x == 1) shown = group_colours[int(cell_value + 0.5)].rgb;
    if (look.x == 2) shown = group_colours[gl_FrontFacing ? 0 : 1].rgb;
    Fabric fabric = fabric_light(world, side * normalize(world_normal), side * hollow_front);
    colour = finish(shown * (0.42 + 0.42 * fabric.diffuse));
}
