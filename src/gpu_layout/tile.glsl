// What the passes over a tile of a picture share.

// Bindings of set 0, the same for all shaders.
const int binding_fragments = 0; // columns of floats
const int binding_picture = 1;
const int binding_lights = 2;
const int binding_samples = 3;
const int binding_lamps = 4;
const int binding_albedo = 5;
const int binding_instances = 6;
const int binding_meshes = 7;
const int binding_materials = 8;
const int binding_textures = 9;
const int binding_codes = 10;  // light of 256 codes, three tables
const int binding_places = 11; // of looks in a pixel
const int binding_seen = 12;   // per pixel of the apron
const int binding_records = 13;
const int binding_spans = 14; // per pixel of the tile
const int binding_behind = 15;
const int binding_counters = 16;
const int binding_listed = 17; // pixels of the tile
const int binding_output = 18;
const int binding_chain = 19;
const int binding_irradiance = 20;
const int binding_mips = 21;
const int binding_ids = 22; // a layer per look: instance and triangle
const int binding_count = 23;

// Specialization constants of the shaders that look.
const int constant_looks = 0; // per pixel: several inside it, and one through its middle
const int constant_wave = 1;  // 0: what is seen first; 1: what is behind it
const int constant_through = 2; // 1 where something can be seen through

const uint nothing = 0xffffffffu;

// How a layer is read from columns, as draw/layer_list.h has it.
const int read_one = 0;
const int read_three = 1;
const int read_root = 2;
const int read_unlit = 3; // three, of what no pass gives light

const int most_layers = 16; // of a picture, with the background

struct PictureRecord {
    vec4 across;     // xyz: to the right of the camera, unit length
    vec4 rotation;   // cosine and sine of the environment's turn; ambient brightness; energy compensation, 0 or 1
    vec4 chain;      // scale; angular variance of level 1; of the last level with lamps, and of the first without
    vec4 maps;       // scale of the irradiance map; the report's base level
    ivec4 fragments; // capacity; 0; lights; lamps
    ivec4 samples;   // count; size of the albedo table; layers besides the picture
    vec4 origin;     // rays of sight through places in the picture, pixels
    vec4 origin_dx;
    vec4 origin_dy;
    vec4 direction;
    vec4 direction_dx;
    vec4 direction_dy;
    ivec4 tile;  // x, y, width, height
    ivec4 apron; // the same with the pixels around it
    vec4 surfaces; // x: perceptual roughness of all of them; below 0: their own
    vec4 edges;  // cosine of an edge's bend; of what is lit as one; extent of a look
    vec4 background; // rgb; w: level of blur
    vec4 blur;       // of the two levels read: share and variance of the lamps that are not in them
    ivec4 behind;    // kind of background; size of the panorama
    vec4 panorama;   // x: scale; y: whether the pipeline is the report's, 0 or 1
    vec4 report;     // its powers: decode, exposure, encode, back
    uvec4 addresses; // of the geometry; of the panorama
    ivec4 layers[4]; // most_layers times: 4 * column + how it is read; -1: the background
};

// A surface of a pixel that is lit at one point.
struct FragmentRecord {
    uvec4 ids;  // instance, triangle, pixel of the tile, look
    vec4 place; // x and y in the picture, pixels; share of the pixel; extent
};

// Raster passes: from the world, relative to the origin of the rays, to the target.
struct RasterConstants {
    vec4 row_x;
    vec4 row_y;
    vec4 row_z;
    vec4 row_w;
    ivec4 look;
};

// Counters: groups of fragments along three axes, and fragments; the same of listed pixels.
const int counter_fragment_groups = 0;
const int counter_fragments = 3;
const int counter_listed_groups = 4;
const int counter_listed = 7;
const int counter_count = 8;

const int group_size_of_looks = 64; // listed pixels
