#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "backdrop.glsl"
in vec3 world;
flat in int is_ground;
out vec4 colour;

void main() {
    vec3 studio = backdrop(normalize(world - eye.xyz));

    // The ground: a pool of light that fades into the studio
    vec3 up = vec3(0.0, 1.0, 0.0);
    float away = length(world.xz - stage.xz) / stage.w;
    float visible = key_visibility(world, up, 2.2);
    float open = ball_openness(world, up);
    float pool = exp(-0.55 * away * away);
    vec3 light = key_colour * to_light.y * mix(0.30, 1.0, visible) * (0.74 + 0.20 * pool) + sky_colour * open * 0.85;
    vec3 ground = vec3(0.70, 0.675, 0.64) * light;

    float fade = is_ground == 1 ? smoothstep(0.8, 4.2, away) : 1.0;
    vec3 shown = mix(ground, studio, fade);

    // The corners of the picture fall off a little
    vec2 place = gl_FragCoord.xy * viewport.zw - 0.5;
    colour = finish(shown * (1.0 - 0.32 * dot(place, place)));
}
