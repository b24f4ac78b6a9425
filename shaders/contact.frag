#version 330 core
in vec2 within;
flat in vec3 ink;
out vec4 colour;

void main() {
    float inside = dot(within, within);
    if (inside > 1.0) discard;
    colour = vec4(mix(ink, vec3(0.16, 0.09, 0.02), smoothstep(0.45, 0.75, inside)), 0.95);
}
