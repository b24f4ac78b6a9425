#version 330 core
#include "frame.glsl"
flat in float is_held;
flat in float size;
out vec4 colour;

void main() {
    vec2 from_middle = (gl_PointCoord - 0.5) * size;
    float away = length(from_middle), radius = 0.5 * size;

    // A bright ring with dark edges, seen on any ground
    float ring = abs(away - radius + 4.0);
    vec4 held = vec4(mix(vec3(1.0, 0.93, 0.55), vec3(0.10, 0.10, 0.12), smoothstep(0.8, 1.8, ring)),
                     1.0 - smoothstep(2.2, 3.2, ring));

    // A ball of steel with one light
    vec2 bent = from_middle / radius;
    float light = 0.30 + 0.45 * max(0.6 - 0.8 * bent.y - 0.4 * bent.x, 0.0);
    float gloss = 1.0 - smoothstep(0.05, 0.35, distance(bent, vec2(-0.30, -0.38)));
    vec4 pin = vec4(vec3(light) + 0.55 * gloss, clamp(radius - away, 0.0, 1.0));
    colour = is_held > 0.5 ? held : pin;
}
