#version 330 core
#include "frame.glsl"
#include "cover.glsl"
#include "balls.glsl"
out vec3 world;
out vec3 cover;
out float open;  // what the balls leave of the light from around

// What the shadow map covers of the ground, as one strip of triangles an instance
const int cells = 40;
const float reach = 0.12;  // m

void main() {
    vec2 corner = vec2(float(gl_VertexID / 2), float(gl_InstanceID + gl_VertexID % 2)) * (2.0 / float(cells)) - 1.0;
    mat4 to_world = inverse(shadow_matrix);
    vec3 near = (to_world * vec4(corner, -1.0, 1.0)).xyz, far = (to_world * vec4(corner, 1.0, 1.0)).xyz;
    world = mix(near, far, (stage.y - near.y) / (far.y - near.y));
    cover = cover_of(world, vec3(0.0, 1.0, 0.0), reach);

    // It ends as if nothing cast beyond; what balls darken reaches far, and fades just before
    vec2 to_rim = (1.0 - abs(corner)) / (2.0 * shadow.zw);  // m; the map is 2 wide in its own units
    float inside = min(to_rim.x, to_rim.y);
    if (inside < 1e-4) cover = vec3(0.0);
    open = mix(1.0, ball_ambient(world, vec3(0.0, 1.0, 0.0)), smoothstep(0.0, 0.1, inside));
    gl_Position = view_projection * vec4(world, 1.0);
    if (eye.y <= stage.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
