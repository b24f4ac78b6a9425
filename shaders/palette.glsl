// Three palettes: studio (pale concrete and a warm wall), dusk (slate under a blue evening), linen (bright paper).
// Colours are linear. They are chosen by comparing, which llvmpipe does for many pixels at once; an array it would read
// pixel by pixel.
vec3 of_palette(vec3 studio, vec3 dusk, vec3 linen) { return style.y == 0 ? studio : style.y == 1 ? dusk : linen; }

vec3 ground_colour() { return of_palette(vec3(0.57, 0.55, 0.52), vec3(0.20, 0.215, 0.25), vec3(0.74, 0.71, 0.64)); }
vec3 horizon() { return of_palette(vec3(0.56, 0.545, 0.525), vec3(0.26, 0.23, 0.27), vec3(0.76, 0.735, 0.68)); }
vec3 zenith() { return of_palette(vec3(0.22, 0.27, 0.33), vec3(0.045, 0.065, 0.13), vec3(0.50, 0.54, 0.55)); }
vec3 sky_light() { return of_palette(vec3(0.40, 0.415, 0.44), vec3(0.19, 0.245, 0.34), vec3(0.37, 0.38, 0.40)); }
vec3 ground_light() { return of_palette(vec3(0.26, 0.235, 0.21), vec3(0.10, 0.10, 0.12), vec3(0.32, 0.30, 0.26)); }
