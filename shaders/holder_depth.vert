#version 330 core
#include "frame.glsl"
#include "holder.glsl"

void main() {
    gl_Position = shadow_matrix * vec4(tube_point().world, 1.0);
    gl_Position.z = max(gl_Position.z, -1.0);
}
