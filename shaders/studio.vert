#version 330 core
#include "frame.glsl"
out vec3 far_point;

// One triangle over the whole picture
const vec2 corners[3] = vec2[](vec2(-1, -1), vec2(3, -1), vec2(-1, 3));

void main() {
    gl_Position = vec4(corners[gl_VertexID], 1.0, 1.0);
    vec4 point = inverse_view_projection * gl_Position;
    far_point = point.xyz / point.w;
}
