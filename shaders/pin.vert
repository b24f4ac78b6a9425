#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float pinned;  // 1 pinned, 2 in the hand
flat out float is_held;
flat out float size;

// The head of a pin, 14 mm wide but never hardly seen, and no wider than the particles are apart; a ring about what the
// hand holds. Other particles are drawn nowhere.
void main() {
    is_held = pinned > 1.5 ? 1.0 : 0.0;
    float pixels = viewport.y * 1.45 / distance(eye.xyz, position);  // in a metre there
    float least = 5.0 * magnified.x;
    size = clamp(0.014 * pixels, least, max(0.6 * shadow.y * pixels, least)) + magnified.x;
    if (is_held > 0.5) size = 22.0 * max(viewport.y / 720.0, 0.6 * magnified.x);
    gl_PointSize = size;
    vec3 world = position + (eye.xyz - position) * (is_held > 0.5 ? 0.03 : 0.006);
    gl_Position = pinned > 0.5 ? view_projection * vec4(world, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
