#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "hard.glsl"
in vec3 world;
in vec3 world_normal;
in vec3 own_normal;
in vec3 cover;
flat in float is_steered;
out vec4 colour;

const vec3 light_part = vec3(0.80, 0.775, 0.73);
const vec3 dark_part = vec3(0.50, 0.485, 0.47);
const vec3 ring_colour = vec3(0.87, 0.22, 0.12);

// Two opposite quarters of the ball are darker, and so is a thin ring across them, so that it is seen to turn about any
// axis. Edges are as soft as a pixel. The ring of the ball that the keys lead is red.
vec3 pattern(vec3 own) {
    float quarters = own.x * own.z, ring = abs(own.y) - 0.08;
    float dark = smoothstep(-fwidth(quarters), fwidth(quarters), quarters);
    float on_ring = 1.0 - smoothstep(-fwidth(ring), fwidth(ring), ring);
    vec3 plain = mix(light_part, dark_part, max(dark, on_ring));
    return is_steered > 0.5 ? mix(plain, ring_colour, on_ring) : plain;
}

void main() { colour = hard(pattern(normalize(own_normal)), 0.9, world, normalize(world_normal), cover); }
