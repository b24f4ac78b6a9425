#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 4) in float lift;  // bend springs are drawn above the cloth, or they would hide the structural ones [m]
flat out int is_bend;

void main() {
    is_bend = lift > 0.0 ? 1 : 0;
    vec3 world = position + normal * lift;
    world += (eye.xyz - world) * 0.003;
    gl_Position = view_projection * vec4(world, 1.0);
}
