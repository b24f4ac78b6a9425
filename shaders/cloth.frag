#version 330 core
#include "frame.glsl"
#include "light.glsl"
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
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz);

    // Fibres scatter: the key light wraps around a little, and a part of it comes through from behind
    float wrapped = max((facing + 0.22) / 1.22, 0.0);
    float visible = key_visibility(world, normal * sign(facing), 0.010);
    float key = wrapped * mix(1.0, visible, smoothstep(0.03, 0.28, facing));
    float through = max(-facing, 0.0) * 0.22;
    float ambient = ball_ambient(world, normal);
    vec3 light = key_colour * (key + through) + light_from_around(normal) * ambient;

    // Sheen at grazing angles
    float grazing = pow(1.0 - abs(dot(normal, to_eye)), 4.0);
    vec3 sheen = mix(albedo, vec3(1.0), 0.35) * grazing * (0.30 * ambient + 0.25 * key);
    colour = finish(albedo * light + sheen * 0.6);
}
