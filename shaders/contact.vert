#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
out vec2 within;  // within the dot; 0, 0 on the needle

// A dot that faces the eye, and a needle along the contact normal
const vec2 dot_corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(-1, 1), vec2(1, -1), vec2(1, 1));

void main() {
    vec3 to_eye = normalize(eye.xyz - point);
    float pixel = distance(eye.xyz, point) * 1.1 * viewport.w;
    vec3 side = normalize(cross(normal, to_eye) + vec3(1e-6, 0.0, 0.0));
    vec3 world = point;
    if (gl_VertexID < 6) {
        within = dot_corners[gl_VertexID];
        world += (side * within.x + cross(to_eye, side) * within.y) * 3.2 * pixel;
    } else {
        within = vec2(0.0);
        world += gl_VertexID == 8 ? normal * 26.0 * pixel : side * (gl_VertexID == 6 ? 1.4 : -1.4) * pixel;
    }
    world += (eye.xyz - world) * 0.006;
    gl_Position = view_projection * vec4(world, 1.0);
}
