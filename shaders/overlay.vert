#version 330 core
#include "frame.glsl"
layout(location = 0) in vec2 position;  // [pixel], from the top left
layout(location = 1) in vec2 texture_position_in;
layout(location = 2) in vec4 tint;
out vec2 texture_position;
out vec4 paint;

void main() {
    texture_position = texture_position_in;
    paint = tint;
    vec2 clip = position * page.zw * 2.0 - 1.0;
    gl_Position = vec4(clip.x, -clip.y, 0.0, 1.0);
}
