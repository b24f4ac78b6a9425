#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 2) in float pinned;
flat out float is_pinned;
flat out float size;

void main() {
    is_pinned = pinned;
    vec3 world = position + (eye.xyz - position) * 0.005;
    gl_Position = view_projection * vec4(world, 1.0);

    // No larger than the spacing leaves room for
    float room = 0.55 * shadow.y * viewport.y / distance(eye.xyz, position) * 1.45;
    size = max(min(room, viewport.y / 720.0 * 7.0), 2.0 * magnified.x) * (pinned > 0.5 ? 1.7 : 1.0) + magnified.x;
    gl_PointSize = size;
}
