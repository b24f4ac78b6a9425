#version 330 core
#include "frame.glsl"
#include "palette.glsl"
#include "light.glsl"
in vec3 world;
in vec3 cover;
in float open;
out vec4 colour;

// Blended over the studio's picture, which is multiplied by about the square root of what is left of the light, as the
// eye sees it. Of red least is left: blending takes as much of all colours, and adds some of the others.
void main() {
    float away = length(world.xz - stage.xz) / stage.w;
    float visible = key_visibility(world, vec3(0.0, 1.0, 0.0), cover, cover.x < 0.998 ? 16 : 0);
    vec3 key = key_colour * to_light.y, sky = sky_light();
    vec3 left = sqrt((key * visible + sky * (1.0 - 0.7 * cover.z)) * (key + sky * open)) / (key + sky);
    float taken = max(1.0 - left.r, 1e-4);
    vec3 tint = sqrt(ground_colour()) * (left - left.r) / taken;
    colour = vec4(tint, (taken + (pixel_noise() - 0.5) / 255.0) * (1.0 - smoothstep(0.3, 2.6, away)));
}
