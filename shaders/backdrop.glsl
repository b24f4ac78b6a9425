// The studio behind everything: light at the horizon, cooler above.
vec3 backdrop(vec3 direction) {
    float height = direction.y;
    vec3 horizon = vec3(0.80, 0.775, 0.74);
    vec3 above = vec3(0.40, 0.50, 0.60);
    vec3 below = vec3(0.62, 0.59, 0.555);
    vec3 colour = mix(horizon, above, smoothstep(0.0, 0.85, height));
    return mix(colour, below, smoothstep(0.0, 0.9, -height));
}
