#version 330 core
#include "frame.glsl"

// Two triangles of ground, which hide what is below, then one over the whole picture behind everything
const vec2 corners[9] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1),
                               vec2(-1, -1), vec2(3, -1), vec2(-1, 3));

void main() {
    vec2 corner = corners[gl_VertexID];
    if (gl_VertexID < 6) {
        vec3 world = stage.xyz + vec3(corner.x, 0.0, corner.y) * 7.0 * stage.w;
        gl_Position = view_projection * vec4(world, 1.0);
        if (eye.y <= stage.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    } else {
        gl_Position = vec4(corner, 1.0, 1.0);
    }
}
