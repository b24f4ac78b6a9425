// The cloth's weave, drawn from where a point is in the cloth laid out flat: it stretches with the cloth.

// 0.5 on stripes over half of each period, -0.5 between them; as soft as a pixel, and fading before they alias
float stripes(float position) {
    float pixel = max(abs(dFdx(position)) + abs(dFdy(position)), 1e-3);
    float from_edge = abs(fract(position) - 0.5) - 0.25;
    return clamp(from_edge / pixel, -0.5, 0.5) * max(1.0 - pixel, 0.0);
}

// What a number is of the fabric; 0 of a plain one
float of_fabric(float cotton, float silk, float denim) {
    return style.x == 0 ? cotton : style.x == 1 ? silk : style.x == 2 ? denim : 0.0;
}

struct Woven {
    float shade;  // by how much it is lighter or darker; 1 on average
    float white;  // how much of white threads is seen, in [0, 1]
    vec2 tilt;    // of the normal, along the rows and along the columns
};

// `place` is in the cloth, `extent` its size [m].
Woven weave(vec2 place, vec2 extent) {
    const float check = 0.05, hem = 0.014;
    place /= unit();
    extent /= unit();

    // A whole number of checks along each side, and as much of one at both ends
    vec2 counted = max(floor(extent / check + 0.25) + 0.5, 1.5);
    vec2 at = place / extent * counted;
    Woven woven = Woven(1.0 + of_fabric(0.15, 0.0, 0.0) * (stripes(at.x) + stripes(at.y)), 0.0, vec2(0.0));

    // Diagonal threads, seen from near; in relief only where each takes some pixels
    float thread = (place.x + place.y) / of_fabric(0.0036, 0.0022, 0.0046), up = stripes(thread);
    woven.shade += of_fabric(0.14, 0.03, 0.34) * up;
    woven.white = of_fabric(0.0, 0.0, 0.30) * (0.5 - up);
    float pixel = abs(dFdx(thread)) + abs(dFdy(thread));
    woven.tilt = vec2(of_fabric(0.20, 0.06, 0.35) * sin(6.2831853 * thread) * max(1.0 - 3.0 * pixel, 0.0));

    // The hem is two layers, sewn down along a line; its edge is round
    vec2 from_edge = min(place, extent - place);
    float edge = min(from_edge.x, from_edge.y);
    float wide = min(hem, 0.04 * min(extent.x, extent.y));
    float pixel_wide = max(abs(dFdx(edge)) + abs(dFdy(edge)), 1e-6), pixels = (edge - wide) / pixel_wide;
    float seam = clamp(1.2 - abs(pixels), 0.0, 1.0);
    woven.shade *= 1.0 - 0.10 * clamp(0.5 - pixels, 0.0, 1.0) - 0.30 * seam;
    vec2 outward = sign(place - 0.5 * extent) * (from_edge.x < from_edge.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    float bent = clamp(1.0 - edge / max(0.25 * wide, 1.5 * pixel_wide), 0.0, 1.0);
    float at_seam = clamp(1.5 - abs(edge - wide) / max(0.15 * wide, pixel_wide), -1.0, 1.0) * sign(edge - wide);
    woven.tilt += outward * (1.1 * bent * bent + 0.35 * max(at_seam, 0.0));
    return woven;
}
