// The scene as shaders read it. Offsets in the geometry buffer are in words of 32 bits.

const int parameter_room = (parameter_numbers + 3) / 4 * 4;
const int texture_room = (texture_count + 3) / 4 * 4;
const uint no_words = 0xffffffffu; // offset of an attribute that a mesh does not have

struct InstanceRecord {
    vec4 row_x; // world from mesh
    vec4 row_y;
    vec4 row_z;
    vec4 normal_x; // world from mesh for normals, rows
    vec4 normal_y;
    vec4 normal_z; // w: -1 if the transform mirrors, else 1
    uvec4 ids;     // mesh, material
    uint sets[texture_room]; // offsets of the material's texture coordinates: 2 words per vertex
};

struct MeshRecord {
    uvec4 vectors; // offsets of positions and normals (3 words per vertex), tangents and colours (4 words)
    uvec4 others;  // x: offset of the triangles, 3 words each
};

// A use of a texture by a material.
struct UseRecord {
    vec4 row_u; // applied to (u, v, 1)
    vec4 row_v;
    ivec4 ids; // x: texture; -1: none
};

struct MaterialRecord {
    float factors[parameter_room]; // indexed by the parameter numbers of shading/material/
    float normal_scales[texture_room];
    vec4 phong_diffuse;  // w: 1 if given
    vec4 phong_specular; // w: 1 if given
    vec4 phong_exponent; // x; y: 1 if given; z: alpha cutoff
    ivec4 kind;          // alpha mode; 1 if unlit; number of textures
    vec4 smoothness;     // typical alpha by each shading model: ggx, phong
    int used[texture_room]; // indices into `uses` of those textures
    UseRecord uses[texture_count];
};

const int wrap_repeat = 0;
const int wrap_mirrored = 1;
const int wrap_clamp = 2;
// Bits of a texture's filters.
const int filter_magnify_nearest = 1;
const int filter_minify_nearest = 2;
const int filter_nearest_mipmap = 4;
const int most_texture_levels = 16;

// A PackedTexture, whose texels are 8-bit codes in one word or half floats in two.
struct TextureRecord {
    uvec4 place;  // address of the texels, low and high word; 1 for half floats; which table of codes
    ivec4 reading; // wrap mode of u, of v; filter bits; number of levels
    ivec4 levels[16]; // per level: width, height, first texel
};
