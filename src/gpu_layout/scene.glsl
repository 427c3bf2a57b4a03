// A scene as shaders read it. Words are 32 bits; places in the geometry buffer count words.

const int parameter_room = (parameter_numbers + 3) / 4 * 4;
const int texture_room = (texture_count + 3) / 4 * 4;
const uint no_words = 0xffffffffu; // an attribute that a mesh does not have

struct InstanceRecord {
    vec4 row_x; // world from mesh
    vec4 row_y;
    vec4 row_z;
    vec4 normal_x; // world from mesh for normals, rows
    vec4 normal_y;
    vec4 normal_z; // w: -1 where the transform mirrors, else 1
    uvec4 ids;     // mesh, material
    uint sets[texture_room]; // texture coordinates of the material's textures: 2 words a vertex
};

struct MeshRecord {
    uvec4 vectors; // positions, normals: 3 words a vertex; tangents, colours: 4
    uvec4 others;  // triangles: 3 words each
};

// One use of a texture.
struct UseRecord {
    vec4 row_u; // applied to (u, v, 1)
    vec4 row_v;
    ivec4 ids; // texture, -1: none
};

struct MaterialRecord {
    float factors[parameter_room]; // by the numbers of shading/material/
    float normal_scales[texture_room];
    vec4 phong_diffuse;  // w: 1 where given
    vec4 phong_specular; // w: 1 where given
    vec4 phong_exponent; // x; y: 1 where given; z: alpha's cutoff
    ivec4 kind;          // alpha mode; 1 if unlit; how many textures it has
    int used[texture_room]; // their numbers
    UseRecord uses[texture_count];
};

const int wrap_repeat = 0;
const int wrap_mirrored = 1;
const int wrap_clamp = 2;
// Bits of how texels are found.
const int filter_magnify_nearest = 1;
const int filter_minify_nearest = 2;
const int filter_nearest_mipmap = 4;
const int most_texture_levels = 16;

// Texels as PackedTexture has them: 8-bit codes in one word, half floats in two.
struct TextureRecord {
    uvec4 place;  // address, low and high word; 1 for half floats; table of codes
    ivec4 reading; // wrap of u, of v; bits of filters; levels
    ivec4 levels[16]; // width, height, first texel
};
