// What the shaders of surfaces and light and their program agree on: the same text in GLSL and, by layout.h, in C++.
// Records hold vectors of four only, so that both languages lay them out alike.

// Specialization constants.
const int constant_pass = 0;
const int constant_model = 1;
const int constant_levels = 2;   // of light
const int constant_textured = 2; // of surfaces: 1 where there are textures

const int pass_direct = 0;
const int pass_ambient = 1;
const int pass_specular = 2;
const int model_ggx = 0;
const int model_phong = 1;
const int levels_matched = 0;
const int levels_report = 1;
const int levels_pipeline = 2; // the report's, in its own order of things

// Fragments: value `column` of fragment i is at column * capacity + i.
const int column_position = 0;
const int column_view = 3;
const int column_normal = 6;
const int column_mirrored_dx = 9;
const int column_mirrored_dy = 12;
const int column_base = 15;
const int column_specular = 18;
const int column_gloss = 21;
const int column_metalness = 22;
const int column_occlusion = 23;
const int column_direct = 24;
const int column_irradiance = 27;
const int column_ambient = 30;
const int column_reflected = 33;
const int column_middle_level = 36;
const int column_depth = 37;
const int column_opacity = 38;
const int column_emitted = 39;
const int column_lit = 42; // 0: unlit, no pass gives it light
const int column_count = 43;

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
