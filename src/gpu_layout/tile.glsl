// Bindings, constants and records of the passes over a tile of an image. A look is one visibility sample of a pixel;
// the apron of a tile is the tile with the pixels around it that edge detection reads.

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
const int binding_codes = 10;  // three tables of linear values for 256 codes
const int binding_places = 11; // positions of the looks in a pixel
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

// Specialization constants of the shaders that determine visibility.
const int constant_looks = 0; // per pixel: several inside it, and one through its centre
const int constant_wave = 1;  // 0: the nearest surfaces; 1: those behind transparent ones
const int constant_through = 2; // 1 if the scene has transparent surfaces

const uint nothing = 0xffffffffu;

// How a layer is read from columns (draw/layer_list.h).
const int read_one = 0;
const int read_three = 1;
const int read_root = 2;
const int read_unlit = 3; // three, of surfaces that no pass lights

const int most_layers = 16; // per image, the background's included

struct PictureRecord {
    vec4 across;     // xyz: unit vector to the right of the camera
    vec4 rotation;   // cosine and sine of the environment's rotation; ambient brightness; energy compensation, 0 or 1
    vec4 chain;      // scale; angular variances: of level 1, of the last level with lamps, of the first without
    vec4 maps;       // scale of the irradiance map; base level of the report's pipeline
    ivec4 fragments; // capacity; 0; numbers of lights and of lamps
    ivec4 samples;   // count; size of the albedo table; number of layers besides the image; count for small fragments
    vec4 origin;     // camera rays through positions in the image, and their change per pixel
    vec4 origin_dx;
    vec4 origin_dy;
    vec4 direction;
    vec4 direction_dx;
    vec4 direction_dy;
    ivec4 tile;  // x, y, width, height
    ivec4 apron; // the same for the apron
    vec4 surfaces; // x: perceptual roughness of all surfaces; negative: their own; y: 1 by the phong model
    vec4 edges;  // cosines between normals: below it is an edge, above it looks may share a fragment; extent of a look
    ivec4 corners; // looks nearest to the corners of a pixel
    vec4 background; // rgb; w: blur level
    vec4 blur;       // for each of the two levels read: weight of the lamps missing in it; its angular variance
    ivec4 behind;    // kind of background; width and height of the panorama
    vec4 panorama;   // x: scale; y: 1 with the report's pipeline, else 0
    vec4 report;     // exponents and factor of the report's pipeline: decode, exposure, encode, back
    uvec4 addresses; // of the geometry and of the panorama, low and high words
    ivec4 layers[4]; // most_layers entries: 4 * column + how it is read; -1: the background
};

// A surface in a pixel, which is lit at one point.
struct FragmentRecord {
    uvec4 ids;  // instance, triangle, pixel of the tile, look
    vec4 place; // x and y in the image, pixels; fraction of the pixel; extent
};

// Push constants of raster passes: rows of the matrix from the world, relative to the camera rays' origin, to clip
// space.
struct RasterConstants {
    vec4 row_x;
    vec4 row_y;
    vec4 row_z;
    vec4 row_w;
    ivec4 look;
};

// Counters: workgroups of fragments along three axes, then fragments; the same for listed pixels.
const int counter_fragment_groups = 0;
const int counter_fragments = 3;
const int counter_listed_groups = 4;
const int counter_listed = 7;
const int counter_count = 8;

const int group_size_of_looks = 64; // listed pixels per workgroup
