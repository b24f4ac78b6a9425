#version 330 core
#include "frame.glsl"
out vec2 at;           // from the particle, along the spring and across it [pixel]
flat out float along;  // length of the spring; 0 on the ring [pixel]
flat out float scale;  // of what is drawn to what it is at 720 rows
flat out vec3 ink;

const vec2 corners[6] = vec2[](vec2(0, -1), vec2(1, -1), vec2(0, 1), vec2(0, 1), vec2(1, -1), vec2(1, 1));

// Rectangles on the screen, before everything: about the particle's spring, the particle, and the unstable mode's spring
void main() {
    bool is_mode = gl_VertexID >= 12, is_ring = gl_VertexID >= 6 && !is_mode;
    vec4 first = is_mode ? mode_spring[0] : failure[0], last = is_mode ? mode_spring[1] : failure[1];
    vec4 from = view_projection * vec4(first.xyz, 1.0), to = view_projection * vec4(last.xyz, 1.0);
    ink = is_mode ? vec3(0.92, 0.16, 0.08) : vec3(1.0);
    scale = max(viewport.y / 720.0, 0.6 * magnified.x);
    vec2 start = from.xy / from.w * 0.5 * viewport.xy, end = to.xy / to.w * 0.5 * viewport.xy;
    along = is_ring ? 0.0 : length(end - start);
    vec2 ahead = along > 0.5 ? (end - start) / along : vec2(1.0, 0.0);
    float room = (is_ring ? 22.0 : 6.0) * scale;
    vec2 corner = corners[gl_VertexID % 6];
    at = vec2(mix(-room, along + room, corner.x), corner.y * room);
    vec2 pixel = start + ahead * at.x + vec2(-ahead.y, ahead.x) * at.y;
    gl_Position = first.w * min(from.w, to.w) > 0.0 ? vec4(pixel * 2.0 * viewport.zw, -1.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
