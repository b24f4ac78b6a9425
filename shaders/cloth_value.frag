#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
in vec3 world;
in vec3 world_normal;
in float hollow_front;
in vec3 cover;
in float vertex_value;
flat in float cell_value;
out vec4 colour;

vec3 value_colour(float value) {
    float position = clamp(value, 0.0, 1.0) * 8.0;
    int first = min(int(position), 7);
    return mix(value_colours[first].rgb, value_colours[first + 1].rgb, position - float(first));
}

// As the legend shows it, in a white light that is half the same everywhere
void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 shown = value_colour(vertex_value);
    if (look.x == 1) shown = group_colours[int(cell_value + 0.5)].rgb;
    if (look.x == 2) shown = group_colours[gl_FrontFacing ? 0 : 1].rgb;
    vec3 normal = side * normalize(world_normal);
    float facing = dot(normal, to_light.xyz), hollow = side * hollow_front;
    float visible = mix(1.0, key_visibility(world, normal * sign(facing), cover, 6), smoothstep(0.03, 0.28, facing));
    float ambient = ball_ambient(world, normal) * (1.0 - (hollow > 0.0 ? 0.60 : 0.15) * hollow);
    colour = coded(shown * (0.42 + 0.50 * max((facing + 0.22) / 1.22, 0.0) * visible + 0.13 * ambient));
}
