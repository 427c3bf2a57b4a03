// Environments baked for renderers that look them up once: the whole public interface of the library.
//
//     const lambent::Panorama panorama = lambent::Panorama::load("panorama.hdr");
//     const lambent::Specular specular = lambent::bake_specular(panorama, {.size = 256});
//     lambent::write_ktx2(specular.cube, "specular.ktx2");
//
// Light is linear RGB of Rec. 709 primaries, proportional to radiance; one unit of a panorama is one nit
// (cd/m^2) unless its maker says otherwise. +Y is up. All of it may be called from several threads at once,
// and uses every processor by oneTBB. What goes wrong is a BakeError, or std::bad_alloc.
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

/// A failure that a user can act on: what() is one line with what, where and why.
class LAMBENT_API BakeError : public std::runtime_error {
public:
    enum class Kind {
        bad_argument, ///< out of the range that the function documents
        bad_input,    ///< a file is missing, broken, hostile or of a kind that is not read
        cannot_write, ///< a file could not be created, written or renamed
    };

    BakeError(Kind kind, const std::string& line) : std::runtime_error(line), kind_(kind) {}

    Kind kind() const noexcept { return kind_; }

private:
    Kind kind_;
};

/// What a built-in environment is made with. Sun and haze are for "sky" only.
struct BuiltinOptions {
    int width = 0; ///< a power of two from 64 to 8192; half as high. 0: the environment's own, 1024 or 2048
    float sun_azimuth = -0.8f;  ///< radians about +Y, from +Z towards +X
    float sun_elevation = 0.7f; ///< radians above the horizon, -0.1 to pi/2
    float turbidity = 2.2f;     ///< optical depth of air with haze over that of air alone, 1.5 (clear) to 10
};

/// A picture of all directions, equirectangular: rows from the zenith (+Y) down, +X in the middle column, +Z
/// a quarter of the width to its right. Texels keep 9 bits of their largest channel. Nobody changes them:
/// copies share them.
class LAMBENT_API Panorama {
public:
    /// Reads a Radiance .hdr or OpenEXR .exr, told apart by content. Texels that are not finite or above 1e10
    /// get the mean of their neighbours, negative light becomes 0, odd shapes are stretched over the sphere:
    /// warnings(). Throws bad_input.
    static Panorama load(const std::filesystem::path& path);

    /// From memory: rows from the top, three floats a texel, width * height * 3 in all, mended as load()
    /// does. Throws bad_argument unless the width is 2 to 65536, the height 1 to 65536, and both fit 2^28
    /// texels.
    static Panorama from_pixels(int width, int height, std::span<const float> rgb);

    /// "kitchen", "studio", "sky" or "furnace" (radiance 1 everywhere). One unit is 15000 / 9 nits in the
    /// kitchen, 15000 in the sky. Throws bad_argument.
    static Panorama builtin(std::string_view name, const BuiltinOptions& options = {});

    int width() const;
    int height() const;

    /// Column x from the left, row y from the top. Throws bad_argument outside the picture.
    std::array<float, 3> radiance(int x, int y) const;

    /// What was mended, one line each; none for most files.
    const std::vector<std::string>& warnings() const;

    // No moves: there is no panorama without texels.
    Panorama(const Panorama&) = default;
    Panorama& operator=(const Panorama&) = default;
    ~Panorama() = default;

private:
    friend struct PanoramaAccess; // the library's own
    struct Texels;
    explicit Panorama(std::shared_ptr<const Texels> texels) : texels_(std::move(texels)) {}

    std::shared_ptr<const Texels> texels_;
};

/// Light on the faces of a cube. `values` holds RGB level by level (each half as wide as the one before), in
/// a level the faces +X -X +Y -Y +Z -Z, in a face rows from the top and texels from the left.
///
/// Texel (x, y) of a face lies in the direction, with s = (2x + 1) / n - 1 and t = (2y + 1) / n - 1 on faces
/// n wide,
///     +X ( 1, -t, -s)    +Y (s,  1,  t)    +Z ( s, -t,  1)
///     -X (-1, -t,  s)    -Y (s, -1, -t)    -Z (-s, -t, -1)
/// which is how OpenGL, Vulkan and Direct3D look cubes up. [Vulkan 1.3, "Cube Map Face Selection"]
struct CubeMap {
    int size = 0;   ///< of a face at level 0, in texels
    int levels = 0; ///< 1 to as many as halve `size` down to 1
    std::vector<float> values;

    int face_size(int level) const { return size >> level > 0 ? size >> level : 1; }

    /// Where the first of the three floats of a texel is in `values`.
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

/// What a level of specular light is averaged with, about the mirrored direction R = N = V; each over its
/// integral.
enum class Lobe {
    ggx,   ///< D(h) N.L, h half way between N and L [Karis 2013, "Real shading in Unreal Engine 4"]
    phong, ///< (R.L)^n with n = 2 / alpha^2 - 2, kept within 0.01 to 1e6 [Walter et al. 2007, 5.2]
};

/// Perceptual roughness (the square root of alpha) of level l of n, with t = l / (n - 1).
enum class RoughnessMapping {
    linear, ///< t
    cmgen,  ///< 1 - sqrt(1 - t), as Filament's cmgen bakes and its shaders look up
};

struct SpecularOptions {
    int size = 256; ///< of a face at level 0, a power of two from 1 to 4096; levels go down to one texel
    Lobe lobe = Lobe::ggx;
    RoughnessMapping mapping = RoughnessMapping::linear;
    double error = 0.01; ///< relative RMSE aimed at in each level, 0.0005 to 0.2
};

struct SpecularLevel {
    double perceptual_roughness = 0.0;
    double error = 0.0; ///< relative RMSE found at some texels, against the sum over the panorama in double
};

struct Specular {
    CubeMap cube; ///< radiance; level 0 is the panorama itself, as sharp as its texels
    std::vector<SpecularLevel> levels;
};

/// Specular light by roughness. `progress` is called with the share done, 0 to 1, by one thread at a time.
/// Throws bad_argument.
LAMBENT_API Specular bake_specular(const Panorama& panorama, const SpecularOptions& options = {},
                                   const std::function<void(double)>& progress = {});

/// Irradiance, the integral of radiance times the cosine (lux for radiance in nits), by direction of the
/// surface normal: one level, faces of `size` texels. A Lambertian surface of albedo a reflects a / pi of it.
/// Throws bad_argument unless the size is 1 to 4096.
LAMBENT_API CubeMap bake_irradiance(const Panorama& panorama, int size = 32);

/// Nine RGB coefficients.
using Harmonics = std::array<std::array<double, 3>, 9>;

/// Irradiance on a surface of unit normal (x, y, z), as the sum of c[i] Y[i], cut at 0, with the harmonics Y
///     0.282095, 0.488603 y, 0.488603 z, 0.488603 x, 1.092548 x y, 1.092548 y z, 0.315392 (3 z^2 - 1),
///     1.092548 x z, 0.546274 (x^2 - y^2)
/// The clamped cosine is in the coefficients. Off by a few percent under a single sun.
/// [Ramamoorthi and Hanrahan 2001, "An efficient representation for irradiance environment maps"]
LAMBENT_API Harmonics bake_irradiance_harmonics(const Panorama& panorama);

/// How much a GGX surface reflects in all, by single scattering: F0 R + G. Column x is N.V = (x + 1/2) /
/// size, row y perceptual roughness (y + 1/2) / size. B is R + G: energy scattered more than once is given
/// back by a factor 1 + F0 (1 / B - 1). [Karis 2013; Turquin 2019, "Practical multiple scattering
/// compensation for microfacet models"]
struct SplitSumTable {
    int size = 0;
    std::vector<float> values; ///< R, G, B for each texel, row by row
};

/// The same for every environment. Throws bad_argument unless the size is 2 to 1024.
LAMBENT_API SplitSumTable bake_split_sum_table(int size = 128);

/// How a file stores a texel. Light is cut to what a format holds.
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

/// A KTX 2 file [Khronos, KTX File Format Specification 2.0.4], and a DDS file with the header of Direct3D
/// 10. Whole or not at all: what was there stays until the new file is complete. Throw cannot_write, and
/// bad_argument for a cube whose values are not as many as its size and levels say, for metadata that KTX 2
/// forbids and for `zstd` without Zstandard.
LAMBENT_API void write_ktx2(const CubeMap& cube, const std::filesystem::path& path,
                            const Ktx2Options& options = {});
LAMBENT_API void write_dds(const CubeMap& cube, const std::filesystem::path& path,
                           TexelFormat format = TexelFormat::half4);

} // namespace lambent
