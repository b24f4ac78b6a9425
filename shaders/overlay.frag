#version 330 core
uniform sampler2D atlas;
in vec2 texture_position;
in vec4 paint;
out vec4 colour;

void main() { colour = paint * vec4(1.0, 1.0, 1.0, texture(atlas, texture_position).r); }
