// Cloth in the light of the studio.

// The ways of its threads, in the world; zero on a line, as the hem is, where they cannot be told.
struct Threads {
    vec3 along, across;
};

Threads threads_at(vec3 world, vec3 normal, vec2 place) {
    vec3 right = dFdx(world), up = dFdy(world);
    vec2 place_right = dFdx(place), place_up = dFdy(place);
    vec3 along = right * place_up.y - up * place_right.y;
    float turn = place_right.x * place_up.y - place_right.y * place_up.x;
    along *= abs(turn) > 0.02 * length(place_right) * length(place_up) ? sign(turn) : 0.0;
    along -= normal * dot(normal, along);
    along *= inversesqrt(max(dot(along, along), 1e-24));
    return Threads(along, cross(along, normal));
}

// The light that it throws to the eye.
// `hollow` is how deep in a fold, in [-1, 1]: less light from around comes there, and more to what stands out
vec3 fabric(vec3 albedo, vec3 world, vec3 normal, Threads threads, float hollow, vec3 cover) {
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz), seen = max(abs(dot(normal, to_eye)), 0.02);

    // Fibres scatter: the key light wraps around a little, and a part of it comes through from behind
    float wrap = of_fabric(0.20, 0.06, 0.12);
    float wrapped = max((facing + wrap) / (1.0 + wrap), 0.0);
    float visible = key_visibility(world, normal * sign(facing), cover, 6);
    float key = wrapped * mix(1.0, visible, smoothstep(0.03, 0.28, facing));
    float through = max(-facing, 0.0) * of_fabric(0.22, 0.15, 0.03) * visible;

    // Folds, and what is near before it, keep light from around off
    float open = 1.0 - (hollow > 0.0 ? 0.50 : 0.15) * hollow;
    open *= 1.0 - 0.50 * (facing > 0.0 ? cover.z : 0.35);
    if (style.x == 3) open = 1.0;
    float ambient = ball_ambient(world, normal) * open;
    key *= 0.75 + 0.25 * min(open, 1.0);
    vec3 around = light_from_around(normal) * ambient;
    vec3 lit = albedo * (key_colour * (key + through) + around);

    // Fibres that stand out of the surface shine where it is seen or lit at a grazing angle  @cite estevez2017
    float rough = of_fabric(0.45, 0.30, 0.60) + 1e-3, to_key = max(facing, 0.0);
    vec3 middle = normalize(to_light.xyz + to_eye);
    float upright = dot(normal, middle), sine = sqrt(max(1.0 - upright * upright, 1e-4));
    float fibres = (1.0 + 0.5 / rough) * pow(sine, 1.0 / rough) * to_key * visible / (4.0 * (to_key + seen - to_key * seen));
    float grazing = (1.0 - seen) * (1.0 - seen) * (1.0 - seen);
    lit += mix(albedo, vec3(1.0), 0.12) * of_fabric(0.30, 0.10, 0.22) * (key_colour * fibres + 2.0 * grazing * around);

    // The gloss of smooth threads, which is wide across them  @cite ward1992
    // A loop, because Mesa's llvmpipe would work both ways of an `if` for all pixels
    for (int i = 0; i < (style.x == 1 ? 1 : 0); ++i) {
        const vec2 wide = vec2(0.20, 0.45);
        vec2 tilt = vec2(dot(middle, threads.along), dot(middle, threads.across)) / (wide * max(upright, 0.05));
        float spread = dot(threads.along, threads.along) / (4.0 * wide.x * wide.y);
        float gloss = exp(-dot(tilt, tilt)) * to_key * visible * spread;
        lit += mix(albedo, vec3(1.0), 0.35) * 0.34 *
               (key_colour * gloss + wall(reflect(-to_eye, normal)) * ambient * (0.25 + 2.0 * grazing));
    }
    return lit;
}
