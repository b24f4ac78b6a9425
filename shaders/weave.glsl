// The cloth's weave, drawn from where a point is in the cloth laid out flat: it stretches with the cloth.

// 0.5 on stripes over half of each period, -0.5 between them; as soft as a pixel, and fading before they alias
float stripes(float position) {
    float pixel = max(abs(dFdx(position)) + abs(dFdy(position)), 1e-3);
    float from_edge = abs(fract(position) - 0.5) - 0.25;
    return clamp(from_edge / pixel, -0.5, 0.5) * max(1.0 - pixel, 0.0);
}

// By how much it is lighter or darker; 1 on average.
// `place` is in the cloth, `extent` its size [m].
float weave(vec2 place, vec2 extent) {
    const float check = 0.05, twill = 0.004, hem = 0.014;

    // A whole number of checks along each side, and as much of one at both ends
    vec2 checks = max(floor(extent / check + 0.25) + 0.5, 1.5);
    vec2 at = place / extent * checks;
    float shade = 1.0 + 0.14 * (stripes(at.x) + stripes(at.y));

    // Diagonal threads, seen from near
    shade += 0.16 * stripes((place.x + place.y) * (1.0 / twill));

    // The hem is two layers, sewn down along a line
    vec2 from_edge = min(place, extent - place);
    float edge = min(from_edge.x, from_edge.y);
    float wide = min(hem, 0.04 * min(extent.x, extent.y));
    float pixels = (edge - wide) / max(abs(dFdx(edge)) + abs(dFdy(edge)), 1e-6);
    float seam = clamp(1.2 - abs(pixels), 0.0, 1.0);
    return shade * (1.0 - 0.16 * clamp(0.5 - pixels, 0.0, 1.0) - 0.24 * seam);
}
