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
    float visible = key_visibility(world, up, 0.015);
    float open = ball_openness(world, up);
    float pool = 1.0 / (1.0 + 0.10 * away * away);
    vec3 light = key_colour * to_light.y * (0.25 + 0.75 * visible) * pool + sky_colour * open * (0.5 + 0.5 * pool);
    vec3 ground = vec3(0.59, 0.57, 0.545) * light;

    float fade = is_ground == 1 ? smoothstep(0.2, 2.4, away) : 1.0;
    vec3 shown = mix(ground, studio, fade);

    // The corners of the picture fall off a little
    vec2 place = gl_FragCoord.xy * viewport.zw - 0.5;
    colour = finish(shown * (1.0 - 0.40 * dot(place, place)));
}
