// What all shaders know of a frame; the same as FrameData in src/render/frame_data.h.
layout(std140) uniform Frame {
    mat4 view_projection;
    mat4 inverse_view_projection;
    mat4 shadow_matrix;  // world to the shadow map's clip space
    vec4 eye;
    vec4 to_light;
    vec4 viewport;       // width, height [pixel] and their inverses, of what the scene is drawn into
    vec4 page;           // the same of the picture, for the panels
    vec4 stage;          // centre x, height of the ground, centre z, radius [m]
    vec4 shadow;         // a texel of the shadow map [m], the particles' spacing [m]; of the map in a metre, [1/m]
    vec4 magnified;      // x: pixels that the scene is drawn with for one that is shown on a usual display
    ivec4 counts;        // structural springs, shear springs, segments of a sphere's circle, balls that darken
    vec4 balls[8];       // centre, radius [m]
    vec4 node_colours[9];  // by what the last query did with a node; compared, stretched, compressed
    vec4 value_colours[9];  // from the least to the most, linear
    vec4 group_colours[4];  // linear
    ivec4 look;          // groups: 1, sides: 2, else 0; the weave: 1, no weave: 0; the ground's grid: 1 or 0
    vec4 failure[2];     // where the run has diverged, and the other end of a spring there [m]; w: 0 if not shown
    vec4 mode_spring[2];  // ends of the unstable mode's spring [m]; w: 0 if not shown
    ivec4 style;         // fabric: 0 cotton, 1 silk, 2 denim, 3 plain; palette: 0 studio, 1 dusk, 2 linen
};

// By how much what is seen is larger than a cloth of a metre or two; patterns and soft edges grow with it
float unit() { return max(0.25 * stage.w, 1.0); }
