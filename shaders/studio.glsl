// The studio: a ground in a pool of light that fades into a wall, light at the horizon and cooler above.

// How much of lines every `period` is in a pixel, in [0, 1]; they are `width` wide, and fade before they alias [m].
float lines(vec2 at, float period, float width) {
    vec2 pixel = max(abs(dFdx(at)) + abs(dFdy(at)), 1e-6);
    vec2 away = abs(fract(at / period + 0.5) - 0.5) * period;
    vec2 shown = clamp((0.5 * max(vec2(width), pixel) - away) / pixel + 0.5, 0.0, 1.0) * min(width / pixel, 1.0);
    shown *= 1.0 - smoothstep(0.10, 0.40, pixel / period);
    return max(shown.x, shown.y);
}

// What a pixel shows of it.
// `world` is a point on the ground, or far away.
vec4 studio(vec3 world, bool is_ground) {
    float away = length(world.xz - stage.xz) / stage.w;
    float pool = 1.0 / (1.0 + 0.22 * away * away);
    vec3 light = key_colour * to_light.y * pool + sky_light() * (0.4 + 0.6 * pool);

    // Polished concrete: clouds, and a dull mirror of the wall
    vec2 at = world.xz * 2.3;
    float clouds = noise(at) + 0.5 * noise(at * 2.7 + 3.1) + 0.25 * noise(at * 7.9);
    vec3 ground = ground_colour() * (1.0 + 0.07 * clouds) * light;
    for (int i = 0; i < look.z; ++i) ground *= 1.0 - 0.12 * lines(world.xz, 0.1, 0.0022) - 0.16 * lines(world.xz, 1.0, 0.005);
    vec3 ahead = normalize(world - eye.xyz);
    float mirrored = 0.5 * pow(1.0 - abs(ahead.y), 5.0);
    ground = mix(ground, wall(vec3(ahead.x, -ahead.y, ahead.z)), mirrored);
    float fade = is_ground ? smoothstep(0.3, 2.6, away) : 1.0;
    vec3 shown = mix(ground, wall(ahead), fade);

    // The corners of the picture fall off a little
    vec2 position = gl_FragCoord.xy * viewport.zw - 0.5;
    return finish(shown * (1.0 - 0.55 * dot(position, position)));
}
