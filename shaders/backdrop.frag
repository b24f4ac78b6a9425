#version 330 core
uniform sampler2D studio_picture;
out vec4 colour;

void main() { colour = texelFetch(studio_picture, ivec2(gl_FragCoord.xy), 0); }
