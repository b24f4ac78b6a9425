// Plaster in the light of the studio.
vec4 matte(vec3 albedo, vec3 world, vec3 normal) {
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz);
    float wrapped = max((facing + 0.12) / 1.12, 0.0);
    float visible = key_visibility(world, normal);
    float key = wrapped * mix(1.0, visible, smoothstep(0.08, 0.40, facing));

    // The ground darkens what faces it
    float near_ground = clamp((world.y - stage.y) / 0.8, 0.0, 1.0);
    float ambient = mix(1.0, 0.55 + 0.45 * near_ground, max(-normal.y, 0.0));

    float gloss = pow(max(dot(normal, normalize(to_light.xyz + to_eye)), 0.0), 28.0) * 0.07 * visible;
    float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0) * 0.10;
    return finish(albedo * (key_colour * key * 0.92 + light_from_around(normal) * ambient) + gloss + rim * ambient);
}
