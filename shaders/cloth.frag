#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "weave.glsl"
#include "fabric.glsl"
in vec3 world;
in vec3 world_normal;
in vec2 place;
flat in vec2 extent;
flat in vec3 front_colour;
flat in vec3 back_colour;
in float hollow_front;
in vec3 cover;
out vec4 colour;

void main() {
    vec3 normal = normalize(world_normal);
    float side = 1.0;
    vec3 albedo = front_colour;
    if (!gl_FrontFacing) {
        side = -1.0;
        albedo = back_colour;
    }

    // The hem is lines, which have no back: it is round, and lit as what faces the eye
    Threads threads = threads_at(world, normal, place);
    if (threads.along == vec3(0.0) && dot(normal, eye.xyz - world) < 0.0) side = -1.0;
    normal *= side;
    for (int i = 0; i < look.y; ++i) {
        Woven woven = weave(place, extent);
        albedo = mix(albedo * woven.shade, vec3(0.55), woven.white);
        normal = normalize(normal + threads.along * woven.tilt.x + threads.across * woven.tilt.y);
    }
    colour = finish(fabric(albedo, world, normal, threads, side * hollow_front, cover));
}
