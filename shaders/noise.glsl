// Smooth noise in [-1, 1], a bump or a dent about each whole number.
float noise_at(vec2 corner) {
    vec3 mixed = fract(vec3(corner.xyx) * 0.1031);
    mixed += dot(mixed, mixed.yzx + 33.33);
    return fract((mixed.x + mixed.y) * mixed.z) * 2.0 - 1.0;
}

float noise(vec2 at) {
    vec2 corner = floor(at), part = at - corner;
    part *= part * (3.0 - 2.0 * part);
    return mix(mix(noise_at(corner), noise_at(corner + vec2(1.0, 0.0)), part.x),
               mix(noise_at(corner + vec2(0.0, 1.0)), noise_at(corner + 1.0), part.x), part.y);
}
