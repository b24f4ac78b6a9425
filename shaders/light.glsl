// One soft key light, light from all around, and what both look like on the screen.
#include "balls.glsl"
uniform sampler2DShadow shadow_map;

const vec3 key_colour = vec3(1.00, 0.945, 0.87) * 1.45;

// Noise of one pixel in [0, 1)  @cite jimenez2014
float pixel_noise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// As sRGB, by square roots, with half a step of noise against banding
vec4 coded(vec3 colour) {
    vec3 root2 = sqrt(clamp(colour, 0.0, 1.0)), root4 = sqrt(root2), root8 = sqrt(root4);
    vec3 srgb = 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * colour;
    return vec4(srgb + (pixel_noise() - 0.5) / 255.0, 1.0);
}

// A film's curve, with a soft toe and shoulder  @cite narkowicz2015
vec4 finish(vec3 colour) {
    vec3 x = max(colour, 0.0) * 0.72;
    return coded(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

// The part of the key light that arrives, in [0, 1]. `cover` is from `cover_of`: only where something casts samples are
// worth it, `most` of them, and an edge is the softer the farther its cause is. The loop makes no turn elsewhere.
float key_visibility(vec3 point, vec3 normal, vec3 cover, int most) {
    int samples = cover.x > 0.002 ? most : 0;
    float sum = samples > 0 ? 0.0 : 1.0 - cover.x;
    float slope = 1.0 - abs(dot(normal, to_light.xyz));
    vec3 at = (shadow_matrix * vec4(point + normal * shadow.x * (1.2 + 2.0 * slope), 1.0)).xyz * 0.5 + 0.5;

    // How the surface's depth in the map goes on aside, so that it casts no shadow on itself
    vec3 facing = mat3(shadow_matrix) * normal;
    vec3 deep = vec3(shadow_matrix[0][2], shadow_matrix[1][2], shadow_matrix[2][2]);
    vec2 aside = -0.25 * dot(deep, deep) * facing.xy / (shadow.zw * min(facing.z, -0.25 * length(deep)));

    // A light that is as wide as a seventh of its distance; points of a disc, turned by the golden angle
    float wide = clamp(0.07 * unit() * cover.y / max(cover.x, 0.01), 1.6 * shadow.x, 0.08 * unit());
    float depth = at.z - 0.0015;
    float start = 2.0 * pixel_noise() - 1.0;
    vec2 way = vec2(start, sqrt(1.0 - start * start));
    const mat2 turn = mat2(-0.73737, 0.67549, -0.67549, -0.73737);
    for (int i = 0; i < samples; ++i) {
        vec2 away = wide * sqrt((float(i) + 0.5) / float(most)) * way;
        sum += texture(shadow_map, vec3(at.xy + away * shadow.zw, min(depth + dot(aside, away), 1.0)));
        way = turn * way;
    }
    return sum / float(max(samples, 1));
}

// Of the sky above, and of the ground below in its colour
vec3 light_from_around(vec3 normal) {
    return mix(ground_light(), sky_light(), normal.y * 0.5 + 0.5);
}

// What a mirror shows of the studio
vec3 wall(vec3 direction) {
    vec3 colour = mix(horizon(), zenith(), smoothstep(-0.05, 0.75, direction.y));
    return mix(colour, ground_colour(), smoothstep(0.0, 0.8, -direction.y));
}
