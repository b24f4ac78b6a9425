#version 330 core
#include "frame.glsl"
out vec2 at;           // from the particle, along the spring and across it [pixel]
flat out float along;  // length of the spring; 0 on the ring [pixel]
flat out float scale;  // of what is drawn to what it is at 720 rows

const vec2 corners[6] = vec2[](vec2(0, -1), vec2(1, -1), vec2(0, 1), vec2(0, 1), vec2(1, -1), vec2(1, 1));

// Two rectangles on the screen, before everything: about the particle, and about its spring
void main() {
    vec4 from = view_projection * vec4(failure[0].xyz, 1.0), to = view_projection * vec4(failure[1].xyz, 1.0);
    scale = max(page.y / 720.0, 0.6) * magnified.x;
    vec2 start = from.xy / from.w * 0.5 * viewport.xy, end = to.xy / to.w * 0.5 * viewport.xy;
    bool is_ring = gl_VertexID >= 6;
    along = is_ring ? 0.0 : length(end - start);
    vec2 ahead = along > 0.5 ? (end - start) / along : vec2(1.0, 0.0);
    float room = (is_ring ? 22.0 : 6.0) * scale;
    vec2 corner = corners[gl_VertexID % 6];
    at = vec2(mix(-room, along + room, corner.x), corner.y * room);
    vec2 pixel = start + ahead * at.x + vec2(-ahead.y, ahead.x) * at.y;
    gl_Position = min(from.w, to.w) > 0.0 ? vec4(pixel * 2.0 * viewport.zw, -1.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
