#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "studio.glsl"
in vec3 far_point;
out vec4 colour;

void main() {
    // Where the ray meets the ground, if it does
    float above = eye.y - stage.y, down = eye.y - far_point.y;
    bool is_ground = above > 0.0 && down > above;
    vec3 world = is_ground ? mix(eye.xyz, far_point, above / down) : far_point;
    colour = studio(world, is_ground);
}
