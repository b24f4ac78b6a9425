#version 330 core
#include "frame.glsl"
out vec3 world;
flat out int is_ground;

// Two triangles of ground, then one over the whole picture behind everything
const vec2 corners[9] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1),
                               vec2(-1, -1), vec2(3, -1), vec2(-1, 3));

void main() {
    vec2 corner = corners[gl_VertexID];
    is_ground = gl_VertexID < 6 ? 1 : 0;
    if (is_ground == 1) {
        world = vec3(stage.x, stage.y, stage.z) + vec3(corner.x, 0.0, corner.y) * 7.0 * stage.w;
        gl_Position = view_projection * vec4(world, 1.0);
        if (eye.y <= stage.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    } else {
        gl_Position = vec4(corner, 1.0, 1.0);
        vec4 far_point = inverse_view_projection * gl_Position;
        world = far_point.xyz / far_point.w;
    }
}
