// What the shaders of surfaces and light and their program agree on: the same text in GLSL and, by layout.h, in C++.
// Records hold vectors of four and rows of numbers that fill such, so that both languages lay them out alike. Numbers that
// the passes agree on, too, are those of shading/numbers.glsl. Value `column` of fragment i is at column * capacity + i.

// Specialization constants.
const int constant_pass = 0;
const int constant_model = 1;
const int constant_levels = 2;   // of light
const int constant_textured = 2; // of surfaces: 1 where there are textures
const int constant_layered = 3;  // of surfaces and light: 1 where there are lobes over the base

const int pass_direct = 0;
const int pass_ambient = 1;
const int pass_specular = 2;

const int group_size = 64;

// A light: local ones stand at a place, others are infinitely far away.
struct LightRecord {
    vec4 position_local;  // w: 1 if local
    vec4 intensity_range; // candela or lux; w: 1 / range
    vec4 axis_inner;      // the way it travels; w: cosine of the inner cone
    vec4 outer;           // x: cosine of the outer cone; y: range squared, below 0 if unlimited
};

// A point of the sample tables.
struct SampleRecord {
    vec4 cap;  // xi2, cosine, sine; w: x in the pixel
    vec4 lobe; // log2 xi2, cosine, sine; w: y in the pixel
};

struct LampRecord {
    vec4 direction; // w: its own variance, square radians
    vec4 light;     // radiance times solid angle
};
