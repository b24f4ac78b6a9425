// The studio: a ground in a pool of light that fades into a wall, light at the horizon and cooler above.
vec3 wall(vec3 direction) {
    vec3 horizon = vec3(0.655, 0.64, 0.62);
    vec3 above = vec3(0.27, 0.33, 0.40);
    vec3 below = vec3(0.56, 0.545, 0.525);
    float height = direction.y;
    vec3 colour = mix(horizon, above, smoothstep(-0.05, 0.75, height));
    return mix(colour, below, smoothstep(0.0, 0.8, -height));
}

// How much of lines every `period` is in a pixel, in [0, 1]; they are `width` wide, and fade before they alias [m].
float lines(vec2 at, float period, float width) {
    vec2 pixel = max(abs(dFdx(at)) + abs(dFdy(at)), 1e-6);
    vec2 away = abs(fract(at / period + 0.5) - 0.5) * period;
    vec2 shown = clamp((0.5 * max(vec2(width), pixel) - away) / pixel + 0.5, 0.0, 1.0) * min(width / pixel, 1.0);
    shown *= 1.0 - smoothstep(0.10, 0.40, pixel / period);
    return max(shown.x, shown.y);
}

// What a pixel shows of it.
// `world` is a point on the ground, or far away; `visible` is the part of the key light that arrives there.
vec4 studio(vec3 world, bool is_ground, float visible) {
    float away = length(world.xz - stage.xz) / stage.w;
    float ambient = ball_ambient(world, vec3(0.0, 1.0, 0.0));
    float pool = 1.0 / (1.0 + 0.10 * away * away);
    vec3 light = key_colour * to_light.y * (0.25 + 0.75 * visible) * pool + sky_colour * ambient * (0.5 + 0.5 * pool);
    vec3 ground = vec3(0.59, 0.57, 0.545) * light;
    for (int i = 0; i < look.z; ++i) ground *= 1.0 - 0.10 * lines(world.xz, 0.1, 0.0022) - 0.13 * lines(world.xz, 1.0, 0.005);
    float fade = is_ground ? smoothstep(0.2, 2.4, away) : 1.0;
    vec3 shown = mix(ground, wall(normalize(world - eye.xyz)), fade);

    // The corners of the picture fall off a little
    vec2 position = gl_FragCoord.xy * viewport.zw - 0.5;
    return finish(shown * (1.0 - 0.40 * dot(position, position)));
}
