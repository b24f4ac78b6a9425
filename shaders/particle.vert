#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 2) in float pinned;
flat out float is_pinned;
flat out float size;

void main() {
    is_pinned = pinned;
    size = viewport.y / 720.0 * (pinned > 0.5 ? 11.0 : 6.0) + 1.0;
    vec3 world = position + (eye.xyz - position) * 0.005;
    gl_Position = view_projection * vec4(world, 1.0);
    gl_PointSize = size;
}
