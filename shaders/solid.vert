#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 5) in vec3 own_position;
layout(location = 9) in float kind;

out vec3 world;
out vec3 world_normal;
out vec3 own;         // in the solid's frame [m]
flat out int shape;  // 0 a box, 1 a capsule, 2 a mesh

void main() {
    world = position;
    world_normal = normal;
    own = own_position;
    shape = int(kind + 0.5);
    gl_Position = view_projection * vec4(world, 1.0);
}
