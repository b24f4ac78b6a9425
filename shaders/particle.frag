#version 330 core
flat in float is_pinned;
flat in float size;
out vec4 colour;

void main() {
    float away = length(gl_PointCoord - 0.5) * size;
    float cover = clamp(0.5 * size - away, 0.0, 1.0);
    vec3 inner = is_pinned > 0.5 ? vec3(1.0, 0.78, 0.10) : vec3(0.99, 0.97, 0.93);
    float edge = smoothstep(0.5 * size - 2.2, 0.5 * size - 1.2, away);
    colour = vec4(mix(inner, vec3(0.07, 0.10, 0.20), edge), cover);
}
