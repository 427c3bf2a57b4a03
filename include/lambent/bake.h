// Prefilters environment maps for renderers that look them up once per shading point: the library's whole interface.
//
//     const lambent::Panorama panorama = lambent::Panorama::load("panorama.hdr");
//     const lambent::Specular specular = lambent::bake_specular(panorama, {.size = 256});
//     lambent::write_ktx2(specular.cube, "specular.ktx2");
//
// Light is linear RGB with Rec. 709 primaries, proportional to radiance; one unit of a panorama is one nit
// (cd/m^2) unless its author says otherwise. +Y is up. All functions may be called from several threads at
// once and run on every processor through oneTBB. They fail with BakeError or std::bad_alloc.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#define LAMBENT_API [[gnu::visibility("default")]]

namespace lambent {

/// A failure that a user can act on: what() is one line that names the object, the position and the reason.
class LAMBENT_API BakeError : public std::runtime_error {
public:
    enum class Kind {
        bad_argument, ///< outside the range that the function documents
        bad_input,    ///< a file is missing, broken, hostile or of an unsupported format
        cannot_write, ///< a file could not be created, written or renamed
    };

    BakeError(Kind kind, const std::string& line) : std::runtime_error(line), kind_(kind) {}

    Kind kind() const noexcept { return kind_; }

private:
    Kind kind_;
};

/// Parameters of a built-in environment. Sun and haze only affect "sky".
struct BuiltinOptions {
    int width = 0; ///< twice the height; a power of two from 64 to 8192. 0: the default, 1024 or 2048
    float sun_azimuth = -0.8f;  ///< radians about +Y, from +Z towards +X
    float sun_elevation = 0.7f; ///< radians above the horizon, -0.1 to pi/2
    float turbidity = 2.2f;     ///< optical depth of air with haze, relative to pure air: 1.5 (clear) to 10
};

/// An equirectangular image of all directions: rows from the zenith (+Y) down, +X in the middle column, +Z a
/// quarter of the width to its right. Texels keep 9 bits of their largest channel. They are immutable, and
/// copies share them.
class LAMBENT_API Panorama {
public:
    /// Reads a Radiance .hdr or OpenEXR .exr file; its content decides which. Texels that are not finite or
    /// above 1e10 become the mean of their neighbours, negative values become 0, and an image that is not
    /// twice as wide as high is stretched over the sphere; warnings() reports all three. Throws bad_input.
    static Panorama load(const std::filesystem::path& path);

    /// Takes pixels from memory: rows from the top, three floats per texel, width * height * 3 in all,
    /// corrected as by load(). Throws bad_argument unless the width is 2 to 65536, the height 1 to 65536 and
    /// width * height at most 2^28.
    static Panorama from_pixels(int width, int height, std::span<const float> rgb);

    /// Makes "kitchen", "studio", "sky" or "furnace" (radiance 1 everywhere). One unit is 15000 / 9 nits in
    /// "kitchen" and 15000 nits in "sky". Throws bad_argument.
    static Panorama builtin(std::string_view name, const BuiltinOptions& options = {});

    int width() const;
    int height() const;

    /// Radiance of the texel in column x from the left and row y from the top. Throws bad_argument outside
    /// the panorama.
    std::array<float, 3> radiance(int x, int y) const;

    /// The corrections made while reading, one line each; empty for most files.
    const std::vector<std::string>& warnings() const;

    // Copied instead of moved, so that every panorama has texels.
    Panorama(const Panorama&) = default;
    Panorama& operator=(const Panorama&) = default;
    ~Panorama() = default;

private:
    friend struct PanoramaAccess; // internal to the library
    struct Texels;
    explicit Panorama(std::shared_ptr<const Texels> texels) : texels_(std::move(texels)) {}

    std::shared_ptr<const Texels> texels_;
};

/// Light on the faces of a cube. `values` holds RGB by level (each half as wide as the previous one), then
/// by face (+X -X +Y -Y +Z -Z), then by row from the top, texels from the left.
///
/// With s = (2x + 1) / n - 1 and t = (2y + 1) / n - 1, the direction of texel (x, y) of a face n texels wide
/// is
///     +X ( 1, -t, -s)    +Y (s,  1,  t)    +Z ( s, -t,  1)
///     -X (-1, -t,  s)    -Y (s, -1, -t)    -Z (-s, -t, -1)
/// as in the cube map lookups of OpenGL, Vulkan and Direct3D. [Vulkan 1.3, "Cube Map Face Selection"]
struct CubeMap {
    int size = 0;   ///< width of a face at level 0, in texels
    int levels = 0; ///< 1 up to the number of levels down to faces of one texel
    std::vector<float> values;

    int face_size(int level) const { return size >> level > 0 ? size >> level : 1; }

    /// Index in `values` of a texel's first float.
    std::size_t index(int level, int face, int x, int y) const
    {
        std::size_t faces_before = 0;
        for (int l = 0; l < level; ++l)
            faces_before += 6 * face_texels(l);
        faces_before += static_cast<std::size_t>(face) * face_texels(level);
        return 3 * (faces_before + static_cast<std::size_t>(y) * static_cast<std::size_t>(face_size(level)) +
                    static_cast<std::size_t>(x));
    }

private:
    std::size_t face_texels(int level) const
    {
        return static_cast<std::size_t>(face_size(level)) * static_cast<std::size_t>(face_size(level));
    }
};

/// The lobe about the reflected direction R = N = V that weights radiance in a level of the specular map; the
/// weights are normalized by their integral.
enum class Lobe {
    ggx,   ///< D(h) N.L, h the half vector of N and L [Karis 2013, "Real shading in Unreal Engine 4"]
    phong, ///< (R.L)^n with n = 2 / alpha^2 - 2, clamped to 0.01 to 1e6 [Walter et al. 2007, 5.2]
};

/// Perceptual roughness (the square root of alpha) of level l of n, with t = l / (n - 1).
enum class RoughnessMapping {
    linear, ///< t
    cmgen,  ///< 1 - sqrt(1 - t), as Filament's cmgen bakes and its shaders look up
};

struct SpecularOptions {
    int size = 256; ///< width of level 0, a power of two from 1 to 4096; levels go down to one texel
    Lobe lobe = Lobe::ggx;
    RoughnessMapping mapping = RoughnessMapping::linear;
    double error = 0.01; ///< target relative RMSE of each level, 0.0005 to 0.2
};

struct SpecularLevel {
    double perceptual_roughness = 0.0;
    double error = 0.0; ///< relative RMSE of a few texels against a sum over all of the panorama in double
};

struct Specular {
    CubeMap cube; ///< radiance; level 0 is the panorama itself, as sharp as its texels
    std::vector<SpecularLevel> levels;
};

/// Filters the panorama with the lobe of each level's roughness. `progress` is called with the fraction done,
/// 0 to 1, by one thread at a time. Throws bad_argument.
LAMBENT_API Specular bake_specular(const Panorama& panorama, const SpecularOptions& options = {},
                                   const std::function<void(double)>& progress = {});

/// Computes irradiance, the integral of radiance times the cosine (lux for radiance in nits), for each
/// direction of the surface normal: one level, faces of `size` texels. A Lambertian surface of albedo a
/// reflects a / pi of it as radiance. Throws bad_argument unless the size is 1 to 4096.
LAMBENT_API CubeMap bake_irradiance(const Panorama& panorama, int size = 32);

/// Nine RGB coefficients.
using Harmonics = std::array<std::array<double, 3>, 9>;

/// Projects irradiance to spherical harmonics. Irradiance on a surface of unit normal (x, y, z) is the sum of
/// c[i] Y[i], clamped at 0, with the harmonics Y
///     0.282095, 0.488603 y, 0.488603 z, 0.488603 x, 1.092548 x y, 1.092548 y z, 0.315392 (3 z^2 - 1),
///     1.092548 x z, 0.546274 (x^2 - y^2)
/// The coefficients include the clamped cosine. The error is a few percent under a single sun.
/// [Ramamoorthi and Hanrahan 2001, "An efficient representation for irradiance environment maps"]
LAMBENT_API Harmonics bake_irradiance_harmonics(const Panorama& panorama);

/// Directional albedo of a GGX surface for single scattering: F0 R + G. Column x is N.V = (x + 1/2) / size,
/// row y perceptual roughness (y + 1/2) / size. B is R + G: the factor 1 + F0 (1 / B - 1) compensates for
/// multiple scattering. [Karis 2013; Turquin 2019, "Practical multiple scattering compensation for
/// microfacet models"]
struct SplitSumTable {
    int size = 0;
    std::vector<float> values; ///< R, G, B for each texel, row by row
};

/// Computes the table, which does not depend on the environment. Throws bad_argument unless the size is 2 to
/// 1024.
LAMBENT_API SplitSumTable bake_split_sum_table(int size = 128);

/// How a file stores a texel. Values are clamped to the range of the format.
enum class TexelFormat {
    half4,  ///< four half floats, alpha 1; at most 65504
    float4, ///< four floats, alpha 1
    rgb9e5, ///< three 9-bit mantissas under a 5-bit exponent; 0 to 65408
};

struct Ktx2Options {
    TexelFormat format = TexelFormat::half4;
    bool zstd = false;                           ///< compressed by Zstandard
    std::map<std::string, std::string> metadata; ///< keys and values in UTF-8
};

/// Whether the library was built with Zstandard.
LAMBENT_API bool can_write_zstd();

/// Write a KTX 2 file [Khronos, KTX File Format Specification 2.0.4] or a DDS file with the Direct3D 10
/// header. An existing file is replaced only once the new one is complete. Throw cannot_write, and
/// bad_argument for a cube whose number of values does not match its size and levels, for metadata that KTX 2
/// forbids and for `zstd` without Zstandard.
LAMBENT_API void write_ktx2(const CubeMap& cube, const std::filesystem::path& path,
                            const Ktx2Options& options = {});
LAMBENT_API void write_dds(const CubeMap& cube, const std::filesystem::path& path,
                           TexelFormat format = TexelFormat::half4);

} // namespace lambent
