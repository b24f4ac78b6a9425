#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "fabric.glsl"
in vec3 world;
in vec3 world_normal;
out vec4 colour;

const vec3 front_colour = vec3(0.72, 0.125, 0.07);
const vec3 back_colour = vec3(0.045, 0.245, 0.265);

void main() {
    vec3 normal = normalize(world_normal);
    vec3 albedo = front_colour;
    if (!gl_FrontFacing) {
        normal = -normal;
        albedo = back_colour;
    }
    Fabric fabric = fabric_light(world, normal);
    colour = finish(albedo * fabric.diffuse + mix(albedo, vec3(1.0), 0.35) * fabric.sheen * 0.6);
}
