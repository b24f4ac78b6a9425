#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 point;
layout(location = 1) in float state;
flat out int node_state;

// The edges of a flat cloth's bounds lie in the cloth: a little towards the eye they are seen
void main() {
    node_state = int(state + 0.5);
    gl_Position = view_projection * vec4(point + (eye.xyz - point) * 0.003, 1.0);
}
