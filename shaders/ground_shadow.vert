#version 330 core
#include "frame.glsl"
out vec3 world;

// What the shadow map covers of the ground, as a strip of two triangles
void main() {
    vec2 corner = vec2(float(gl_VertexID % 2), float(gl_VertexID / 2)) * 2.0 - 1.0;
    mat4 to_world = inverse(shadow_matrix);
    vec3 near = (to_world * vec4(corner, -1.0, 1.0)).xyz, far = (to_world * vec4(corner, 1.0, 1.0)).xyz;
    world = mix(near, far, (stage.y - near.y) / (far.y - near.y));
    gl_Position = view_projection * vec4(world, 1.0);
    if (eye.y <= stage.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
