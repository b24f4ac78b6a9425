// The studio behind everything: light at the horizon, cooler above.
vec3 backdrop(vec3 direction) {
    vec3 horizon = vec3(0.655, 0.64, 0.62);
    vec3 above = vec3(0.27, 0.33, 0.40);
    vec3 below = vec3(0.56, 0.545, 0.525);
    float height = direction.y;
    vec3 colour = mix(horizon, above, smoothstep(-0.05, 0.75, height));
    return mix(colour, below, smoothstep(0.0, 0.8, -height));
}
