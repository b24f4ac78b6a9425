#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 force;   // in full lengths of an arrow
layout(location = 2) in vec3 colour;
out vec2 within;  // within the dot; 0, 0 on the arrow
flat out vec3 ink;

// A dot that faces the eye, and an arrow along the force: a shaft and a head
const vec2 square[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(-1, 1), vec2(1, -1), vec2(1, 1));
const float full_length = 48.0, head = 9.0;  // pixel

void main() {
    vec3 to_eye = normalize(eye.xyz - point);
    float pixel = distance(eye.xyz, point) * 1.1 * viewport.w * magnified.x;
    float strength = length(force), along = strength * full_length;
    vec3 direction = force / max(strength, 1e-9);
    vec3 side = normalize(cross(direction, to_eye) + vec3(1e-6, 0.0, 0.0));
    vec3 world = point;
    within = vec2(0.0);
    if (gl_VertexID < 6) {
        within = square[gl_VertexID];
        world += (side * within.x + cross(to_eye, side) * within.y) * 2.6 * pixel;
    } else if (gl_VertexID < 12) {
        vec2 corner = square[gl_VertexID - 6];
        world += (side * corner.x * 1.1 + direction * (0.5 + 0.5 * corner.y) * max(along - head, 0.0)) * pixel;
    } else {
        float tip = min(along, head);
        float across = gl_VertexID == 14 ? 0.0 : (gl_VertexID == 12 ? 0.38 : -0.38) * tip;
        world += (side * across + direction * (along - (gl_VertexID == 14 ? 0.0 : tip))) * pixel;
    }
    world += (eye.xyz - world) * 0.006;
    ink = colour;
    gl_Position = view_projection * vec4(world, 1.0);
}
