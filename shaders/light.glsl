// One soft key light, light from all around, and what both look like on the screen.
uniform sampler2DShadow shadow_map;

const vec3 key_colour = vec3(1.00, 0.94, 0.86) * 1.02;
const vec3 sky_colour = vec3(0.80, 0.88, 1.00) * 0.46;
const vec3 bounce_colour = vec3(1.00, 0.90, 0.80) * 0.27;

// Noise of one pixel in [0, 1)  [Jimenez 2014]
float pixel_noise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// A linear middle and a soft shoulder, then sRGB, then half a step of noise against banding
vec4 finish(vec3 colour) {
    const float knee = 0.62;
    vec3 shoulder = 1.0 - (1.0 - knee) * exp((knee - colour) / (1.0 - knee));
    vec3 toned = mix(colour, shoulder, step(knee, colour));
    vec3 coded = mix(12.92 * toned, 1.055 * pow(max(toned, 1e-5), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, toned));
    return vec4(coded + (pixel_noise() - 0.5) / 255.0, 1.0);
}

// The part of the key light that arrives, in [0, 1]; `spread` in texels sets how soft the edge is.
// The loop makes no turn where nothing can cast.
float key_visibility(vec3 point, vec3 normal, float spread) {
    vec3 place = (shadow_matrix * vec4(point + normal * shadow.x * 1.8, 1.0)).xyz * 0.5 + 0.5;
    vec2 beyond = abs(place.xy - 0.5);
    int rows = max(beyond.x, beyond.y) < 0.5 ? 4 : 0;
    float step_size = spread * shadow.y;
    float depth = min(place.z - 0.0012, 1.0);
    float lit = 0.0;
    for (int row = 0; row < rows; ++row) {
        vec2 start = place.xy + vec2(-1.5, float(row) - 1.5) * step_size;
        lit += texture(shadow_map, vec3(start, depth));
        lit += texture(shadow_map, vec3(start + vec2(step_size, 0.0), depth));
        lit += texture(shadow_map, vec3(start + vec2(2.0 * step_size, 0.0), depth));
        lit += texture(shadow_map, vec3(start + vec2(3.0 * step_size, 0.0), depth));
    }
    float part = rows > 0 ? lit / 16.0 : 1.0;
    return mix(1.0, part, shadow.z);
}

// The part of the light from all around that the balls leave
float ball_openness(vec3 point, vec3 normal) {
    float open = 1.0;
    for (int i = 0; i < counts.w; ++i) {
        vec3 to_ball = balls[i].xyz - point;
        float distance2 = max(dot(to_ball, to_ball), balls[i].w * balls[i].w);
        float facing = max(dot(normal, to_ball) * inversesqrt(distance2), 0.0);
        open *= 1.0 - 0.85 * facing * balls[i].w * balls[i].w / distance2;
    }
    return open;
}

vec3 light_from_around(vec3 normal) { return mix(bounce_colour, sky_colour, normal.y * 0.5 + 0.5); }
