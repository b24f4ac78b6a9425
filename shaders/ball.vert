#version 330 core
#include "frame.glsl"
#include "cover.glsl"
layout(location = 0) in vec3 position;  // of the unit sphere
layout(location = 3) in vec4 instance;  // centre, radius
layout(location = 4) in vec4 orientation;  // quaternion, from the ball's own frame to the world
layout(location = 8) in float steered;  // by the keys, as one of several: 1, else 0

out vec3 world;
out vec3 world_normal;
out vec3 own_normal;  // in the frame that turns with the ball
out vec3 cover;
flat out float is_steered;

void main() {
    world = instance.xyz + instance.w * position;
    world_normal = position;
    cover = cover_of(world, position, 0.06);
    is_steered = steered;

    // Turned back by the quaternion
    vec3 across = 2.0 * cross(position, orientation.xyz);
    own_normal = position + orientation.w * across + cross(across, orientation.xyz);
    gl_Position = view_projection * vec4(world, 1.0);
}
