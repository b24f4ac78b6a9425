#version 330 core
#include "frame.glsl"
#include "holder.glsl"

// Cords, pegs and rings are too thin for the map's texels
void main() {
    gl_Position = shadow_matrix * vec4(tube_point().world, 1.0);
    gl_Position.z = max(gl_Position.z, -1.0);
    if (from_and_radius.w < 0.0075) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
