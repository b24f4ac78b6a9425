// The studio behind everything: light at the horizon, cooler above.
vec3 backdrop(vec3 direction) {
    vec3 horizon = vec3(0.66, 0.655, 0.645);
    vec3 above = vec3(0.24, 0.31, 0.385);
    vec3 below = vec3(0.52, 0.51, 0.50);
    float height = direction.y;
    vec3 colour = mix(horizon, above, smoothstep(-0.05, 0.75, height));
    return mix(colour, below, smoothstep(0.0, 0.8, -height));
}
