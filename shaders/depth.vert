#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 3) in vec4 instance;  // centre and size; 0, 0, 0, 1 where it is not an array

// What is nearer to the light than the map's depths casts too
void main() {
    gl_Position = shadow_matrix * vec4(instance.xyz + instance.w * position, 1.0);
    gl_Position.z = max(gl_Position.z, -1.0);
}
