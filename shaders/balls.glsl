// The part of the light from all around that the balls leave
float ball_ambient(vec3 point, vec3 normal) {
    float ambient = 1.0;
    for (int i = 0; i < counts.w; ++i) {
        vec3 to_ball = balls[i].xyz - point;
        float distance2 = max(dot(to_ball, to_ball), balls[i].w * balls[i].w);
        float facing = max(dot(normal, to_ball) * inversesqrt(distance2), 0.0);
        ambient *= 1.0 - 0.85 * facing * balls[i].w * balls[i].w / distance2;
    }
    return ambient;
}
