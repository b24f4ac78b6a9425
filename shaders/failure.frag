#version 330 core
in vec2 at;
flat in float along;
flat in float scale;
flat in vec3 ink;
out vec4 colour;

// White or red with black edges, seen on any ground and on every colour of the cloth
void main() {
    float away = along > 0.0 ? length(at - vec2(clamp(at.x, 0.0, along), 0.0)) : abs(length(at) - 15.0 * scale);
    float core = 2.1 * scale, edge = core + 2.2 * scale;
    vec3 paint = mix(ink, vec3(0.03), smoothstep(core - 0.6, core + 0.6, away));
    colour = vec4(paint, 1.0 - smoothstep(edge - 0.7, edge + 0.7, away));
}
