// What pins hang from: a tube along a rod or around a ring, as one strip that winds along it.
layout(location = 0) in vec4 from_and_radius;
layout(location = 1) in vec4 to_and_ring;

const int around = 7;  // points of a turn
const int turns = 12;  // twice as many vertices as points: 2 * around * turns

struct TubePoint {
    vec3 world, normal;
};

TubePoint tube_point() {
    float point = clamp(float(gl_VertexID / 2 + (gl_VertexID % 2) * around - around), 0.0, float(around * (turns - 1)));
    float radius = from_and_radius.w, turn = 6.2831853 * point / float(around);
    float along = point / float(around * (turns - 1));
    vec3 from = from_and_radius.xyz, axis = to_and_ring.w > 0.0 ? to_and_ring.xyz : to_and_ring.xyz - from;
    float length_of = length(axis);
    axis = length_of > 1e-6 ? axis / length_of : vec3(0.0, 1.0, 0.0);
    vec3 side = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
    vec3 other = cross(axis, side);
    if (to_and_ring.w > 0.0) {
        float angle = 6.2831853 * along;
        vec3 out_of_ring = cos(angle) * side + sin(angle) * other;
        vec3 normal = cos(turn) * out_of_ring + sin(turn) * axis;
        return TubePoint(from + to_and_ring.w * out_of_ring + radius * normal, normal);
    }

    // The first and the last third are its round ends
    float polar = 1.5707963 * (clamp(3.0 * along - 1.0, -1.0, 0.0) + clamp(3.0 * along - 2.0, 0.0, 1.0));
    vec3 normal = cos(polar) * (cos(turn) * side + sin(turn) * other) + sin(polar) * axis;
    float part = clamp(3.0 * along - 1.0, 0.0, 1.0);
    return TubePoint(from + part * length_of * axis + radius * normal, normal);
}
