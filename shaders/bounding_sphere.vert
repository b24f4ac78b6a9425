#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 centre;
layout(location = 1) in float radius;
layout(location = 2) in float state;
layout(location = 5) in float hidden;  // 1 behind something
flat out vec4 node_colour;

// Four circles of a sphere, as lines: three along the axes, and the outline as the eye sees it
void main() {
    int segments = counts.z;
    int circle = gl_VertexID / (2 * segments);
    int end = gl_VertexID % (2 * segments);
    float angle = 6.2831853 * float((end + 1) / 2) / float(segments);
    vec2 turn = vec2(cos(angle), sin(angle));

    vec3 point = circle == 0 ? vec3(turn, 0.0) : circle == 1 ? vec3(0.0, turn) : vec3(turn.y, 0.0, turn.x);
    if (circle == 3) {
        vec3 from = (eye.xyz - centre) / max(radius, 1e-9);
        float far = max(length(from), 1.001);
        vec3 ahead = from / far;
        vec3 side = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
        point = ahead / far + sqrt(1.0 - 1.0 / (far * far)) * (side * turn.x + cross(ahead, side) * turn.y);
    }
    node_colour = node_colours[int(state + 0.5)] * vec4(1.0, 1.0, 1.0, 1.0 - 0.65 * hidden);
    gl_Position = view_projection * vec4(centre + radius * point, 1.0);
}
