#version 330 core
flat in vec4 node_colour;
out vec4 colour;

void main() { colour = node_colour; }
