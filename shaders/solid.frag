#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "cover.glsl"
#include "hard.glsl"
in vec3 world;
in vec3 world_normal;
in vec3 own;
flat in int shape;
out vec4 colour;

// Boards of oak along the x axis: rings that are cut at a slant, and fine grain
vec3 wood() {
    float rings = 45.0 * (own.z + 0.35 * own.y) + 3.0 * noise(vec2(own.x * 1.8, own.z * 9.0 + own.y * 5.0));
    float fine = (own.z + own.y) * 420.0, pixel = fwidth(rings), ring = fract(rings);
    float grain = noise(vec2(own.x * 14.0, fine)) * max(1.0 - fwidth(fine), 0.0);
    float late = smoothstep(0.25, 0.85, ring) * smoothstep(0.0, max(0.15, 1.5 * pixel), 1.0 - ring);
    late = mix(late, 0.4, clamp(1.5 * pixel - 0.25, 0.0, 1.0));
    return mix(vec3(0.50, 0.315, 0.165), vec3(0.36, 0.205, 0.098), late) * (1.0 + 0.10 * grain);
}

void main() {
    vec3 normal = normalize(world_normal);
    vec3 albedo = shape == 0 ? wood() : shape == 1 ? vec3(0.10, 0.11, 0.12) : vec3(0.52, 0.50, 0.465);
    float gloss = shape == 0 ? 0.35 : 0.8;
    colour = hard(albedo, gloss, world, normal, cover_of(world, normal, 0.08));
}
