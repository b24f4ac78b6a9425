#version 330 core
#include "node_colour.glsl"
flat in int node_state;
out vec4 colour;

void main() { colour = node_colour(node_state); }
