#version 330 core
#include "frame.glsl"
flat in int is_bend;
out vec4 colour;

void main() {
    vec4 structural = vec4(0.07, 0.10, 0.20, 0.95);
    vec4 shear = vec4(0.98, 0.93, 0.80, 0.80);
    vec4 bend = vec4(0.10, 0.62, 0.78, 0.85);
    colour = is_bend == 1 ? bend : gl_PrimitiveID < counts.x ? structural : shear;
}
