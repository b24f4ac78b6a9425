#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 point;
layout(location = 1) in float state;
layout(location = 5) in float hidden;  // 1 behind something
flat out vec4 node_colour;

// The edges of a flat cloth's bounds lie in the cloth: a little towards the eye they are seen
void main() {
    node_colour = node_colours[int(state + 0.5)] * vec4(1.0, 1.0, 1.0, 1.0 - 0.65 * hidden);
    gl_Position = view_projection * vec4(point + (eye.xyz - point) * 0.003, 1.0);
}
