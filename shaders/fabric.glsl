// Cloth in the light of the studio.
struct Fabric {
    vec3 diffuse;  // light
    vec3 sheen;    // at grazing angles
};

// `hollow` is how deep in a fold, in [-1, 1]: less light from around comes there, and more to what stands out
Fabric fabric_light(vec3 world, vec3 normal, float hollow) {
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(normal, to_light.xyz);

    // Fibres scatter: the key light wraps around a little, and a part of it comes through from behind
    float wrapped = max((facing + 0.22) / 1.22, 0.0);
    float visible = key_visibility(world, normal * sign(facing));
    float key = wrapped * mix(1.0, visible, smoothstep(0.03, 0.28, facing));
    float through = max(-facing, 0.0) * 0.22;
    float ambient = ball_ambient(world, normal) * (1.0 - (hollow > 0.0 ? 0.60 : 0.15) * hollow);
    key *= 1.0 - 0.25 * max(hollow, 0.0);

    float grazing = pow(1.0 - abs(dot(normal, to_eye)), 4.0);
    return Fabric(key_colour * (key + through) + light_from_around(normal) * ambient,
                  vec3(grazing * (0.30 * ambient + 0.25 * key)));
}
