#version 330 core
#include "frame.glsl"
#include "light.glsl"
in vec3 world;
in vec3 world_normal;
in vec3 own_normal;
out vec4 colour;

const vec3 light_part = vec3(0.80, 0.775, 0.73);
const vec3 dark_part = vec3(0.50, 0.485, 0.47);

// Two opposite quarters of the ball are darker, and so is a thin ring across them, so that it is seen to turn about any
// axis. Edges are as soft as a pixel.
vec3 pattern(vec3 own) {
    float quarters = own.x * own.z, ring = abs(own.y) - 0.08;
    float dark = smoothstep(-fwidth(quarters), fwidth(quarters), quarters);
    float on_ring = 1.0 - smoothstep(-fwidth(ring), fwidth(ring), ring);
    return mix(light_part, dark_part, max(dark, on_ring));
}

void main() {
    vec3 normal = normalize(world_normal);
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz);
    float wrapped = max((facing + 0.12) / 1.12, 0.0);
    float visible = key_visibility(world, normal, 0.010);
    float key = wrapped * mix(1.0, visible, smoothstep(0.08, 0.40, facing));

    // The ground darkens what faces it
    float near_ground = clamp((world.y - stage.y) / 0.8, 0.0, 1.0);
    float ambient = mix(1.0, 0.55 + 0.45 * near_ground, max(-normal.y, 0.0));

    float gloss = pow(max(dot(normal, normalize(to_light.xyz + to_eye)), 0.0), 28.0) * 0.07 * visible;
    float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0) * 0.10;
    colour = finish(pattern(normalize(own_normal)) * (key_colour * key * 0.92 + light_from_around(normal) * ambient) + gloss + rim * ambient);
}
