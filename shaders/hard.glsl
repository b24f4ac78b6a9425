// What is hard, in the light of the studio. `gloss` is how much of a mirror it is, in [0, 1].
vec4 hard(vec3 albedo, float gloss, vec3 world, vec3 normal, vec3 cover) {
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz);
    float wrapped = max((facing + 0.25) / 1.25, 0.0);
    float visible = key_visibility(world, normal, cover, 8);
    float key = wrapped * mix(1.0, visible, smoothstep(0.10, 0.55, facing));

    // The ground darkens what faces it
    float near_ground = clamp((world.y - stage.y) / 0.8, 0.0, 1.0);
    float ambient = mix(1.0, 0.40 + 0.60 * near_ground, max(-normal.y, 0.0)) * (1.0 - 0.75 * cover.z);

    float near_light = max(dot(normal, normalize(to_light.xyz + to_eye)), 0.0);
    float seen = 1.0 - max(dot(normal, to_eye), 0.0);
    float mirror = gloss * (0.04 + 0.12 * seen * seen * seen * seen) * ambient;
    vec3 lit = albedo * (key_colour * key * 0.92 + light_from_around(normal) * ambient);
    return finish(mix(lit, wall(reflect(-to_eye, normal)), mirror) + gloss * 0.5 * pow(near_light, 60.0) * visible);
}
