// What is near a point and between it and the light, from the shadow map's depths: it is found at vertices, and so
// costs little; what lies between them is interpolated.
uniform sampler2D shadow_depths;

// @param reach how far about the point [unit()]
// @return the part in [0, 1] of its surroundings that is in shadow; that times how far before it the shadow's cause is
// [unit()]; how much of the light from around is kept off, in [0, 1]
vec3 cover_of(vec3 point, vec3 normal, float reach) {
    // The light's axes, which are the rows of the matrix, and how many metres the map is wide, high and deep
    mat3 rows = transpose(mat3(shadow_matrix));
    vec3 metres = 2.0 * inversesqrt(vec3(dot(rows[0], rows[0]), dot(rows[1], rows[1]), dot(rows[2], rows[2])));
    vec3 at = (shadow_matrix * vec4(point, 1.0)).xyz * 0.5 + 0.5;

    // A surface that is flat goes on along its tangent: what is before that covers it
    vec3 facing = 0.5 * metres * (mat3(shadow_matrix) * normal);
    vec2 slope = clamp(-facing.xy / (facing.z > 0.0 ? max(facing.z, 0.1) : min(facing.z, -0.1)), -8.0, 8.0);

    // Points of a disc, evenly: each is turned by the golden angle
    const int points = 18;
    const mat2 turn = mat2(-0.73737, 0.67549, -0.67549, -0.73737);
    vec2 way = vec2(reach * unit(), 0.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < points; ++i) {
        vec2 away = way * sqrt((float(i) + 0.5) / float(points));
        float depth = textureLod(shadow_depths, at.xy + away / metres.xy, 0.0).r;
        float gap = depth < 1.0 ? ((at.z - depth) * metres.z + dot(slope, away)) / unit() : 0.0;
        float before = smoothstep(0.004, 0.03, gap);
        sum += vec3(gap > 0.008 ? 1.0 : 0.0, max(gap - 0.008, 0.0), before / (1.0 + 9.0 * gap * gap));
        way = turn * way;
    }
    return sum / float(points);
}
