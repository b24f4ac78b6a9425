// One soft key light, light from all around, and what both look like on the screen.
uniform sampler2DShadow shadow_map;
uniform sampler2DShadow shadow_probe;

const vec3 key_colour = vec3(1.00, 0.955, 0.90) * 1.20;
const vec3 sky_colour = vec3(0.80, 0.88, 1.00) * 0.36;
const vec3 bounce_colour = vec3(1.00, 0.88, 0.77) * 0.20;

// Noise of one pixel in [0, 1)  @cite jimenez2014
float pixel_noise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// A linear middle and a soft shoulder, then sRGB by square roots, then half a step of noise against banding
vec4 finish(vec3 colour) {
    const float knee = 0.60;
    vec3 shoulder = 1.0 - (1.0 - knee) * (1.0 - knee) / (max(colour, knee) + 1.0 - 2.0 * knee);
    vec3 toned = mix(colour, shoulder, step(knee, colour));
    vec3 root2 = sqrt(max(toned, 0.0)), root4 = sqrt(root2), root8 = sqrt(root4);
    vec3 coded = 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * toned;
    return vec4(coded + (pixel_noise() - 0.5) / 255.0, 1.0);
}

// The part of the key light that arrives, in [0, 1].
// Four probes tell light and shadow; only an edge is worth the rest. The loops make no turn where nothing can cast.
float key_visibility(vec3 point, vec3 normal) {
    float slope = 1.0 - abs(dot(normal, to_light.xyz));
    vec3 position = (shadow_matrix * vec4(point + normal * shadow.x * (1.2 + 2.0 * slope), 1.0)).xyz * 0.5 + 0.5;
    vec2 texel = 1.0 / vec2(textureSize(shadow_probe, 0)), half_width = 2.2 * texel;
    float depth = min(position.z - 0.0015, 1.0);
    vec2 beyond = abs(position.xy - 0.5);
    int probes = max(beyond.x, beyond.y) < 0.5 ? 1 : 0;
    float lit = probes > 0 ? 0.0 : 4.0;
    vec2 away = half_width + texel;
    for (int i = 0; i < probes; ++i) {
        lit += texture(shadow_probe, vec3(position.xy + away * vec2(-1.0, -1.0), depth));
        lit += texture(shadow_probe, vec3(position.xy + away * vec2(1.0, -1.0), depth));
        lit += texture(shadow_probe, vec3(position.xy + away * vec2(-1.0, 1.0), depth));
        lit += texture(shadow_probe, vec3(position.xy + away * vec2(1.0, 1.0), depth));
    }

    // Nine samples, evenly over a square, in rows that fan out, less than two texels apart, which is how far each is
    // smoothed: along straight columns, or farther apart, an edge would fade in steps
    int rows = lit > 0.01 && lit < 3.99 ? 3 : 0;
    float sum = rows > 0 ? 0.0 : lit * 2.25;
    for (int i = 0; i < rows; ++i) {
        float row = float(i) - 1.0;
        vec2 middle = position.xy + half_width * vec2(0.13 - 0.19 * row * row, 0.82 * row);
        vec2 next = half_width * vec2(0.74, 0.03 + 0.19 * row);
        sum += texture(shadow_map, vec3(middle - next, depth));
        sum += texture(shadow_map, vec3(middle, depth));
        sum += texture(shadow_map, vec3(middle + next, depth));
    }
    return sum / 9.0;
}

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

vec3 light_from_around(vec3 normal) { return mix(bounce_colour, sky_colour, normal.y * 0.5 + 0.5); }
