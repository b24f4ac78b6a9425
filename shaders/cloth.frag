#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "fabric.glsl"
#include "weave.glsl"
in vec3 world;
in vec3 world_normal;
in vec2 place;
flat in vec2 extent;
in float hollow_front;
out vec4 colour;

const vec3 front_colour = vec3(0.72, 0.125, 0.07);
const vec3 back_colour = vec3(0.045, 0.245, 0.265);

void main() {
    vec3 normal = normalize(world_normal);
    vec3 albedo = front_colour;
    float hollow = hollow_front;
    if (!gl_FrontFacing) {
        normal = -normal;
        albedo = back_colour;
        hollow = -hollow;
    }
    for (int i = 0; i < look.y; ++i) albedo *= weave(place, extent);
    Fabric fabric = fabric_light(world, normal, hollow);
    colour = finish(albedo * fabric.diffuse + mix(albedo, vec3(1.0), 0.35) * fabric.sheen * 0.6);
}
