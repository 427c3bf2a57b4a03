// Constants and records shared by the shaders of surfaces and light and the C++ code, which includes them by layout.h.
// Records consist of four-component vectors and of arrays whose size is a multiple of four, so that both languages lay
// them out alike. Constants of the passes themselves are in shading/numbers.glsl. The G-buffer stores value `column` of
// fragment i at index column * capacity + i.

// Specialization constants.
const int constant_pass = 0;
const int constant_model = 1;
const int constant_levels = 2;   // in the light shader
const int constant_textured = 2; // in the surface shader: 1 if materials have textures
const int constant_layered = 3;  // in both: 1 if materials have lobes over the base

const int pass_direct = 0;
const int pass_ambient = 1;
const int pass_specular = 2;

const int group_size = 64;

// A light source; one that is not local is infinitely far away.
struct LightRecord {
    vec4 position_local;  // w: 1 if local
    vec4 intensity_range; // candela or lux; w: 1 / range
    vec4 axis_inner;      // direction in which the light travels; w: cosine of the inner cone angle
    vec4 outer;           // x: cosine of the outer cone angle; y: range squared, negative if unlimited
};

// A point of each of the sample tables (SampleTables), those of small fragments after the others: xi2 and the cosine and sine of the azimuth.
struct SampleRecord {
    vec4 cap;  // xi2, cosine, sine; w: x in the pixel
    vec4 lobe; // log2 xi2, cosine, sine; w: y in the pixel
};

struct LampRecord {
    vec4 direction; // w: angular variance of the lamp, square radians
    vec4 light;     // radiance times solid angle
};
