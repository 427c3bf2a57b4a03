#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/chain/kernels.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/chain/kernels.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "environment/chain/wide_cube.h"
#include "environment/chain/wide_faces.h"
#include "environment/panorama/wide_panorama.h"

CubeView view(const CubeChain& chain)
{
    return {chain.halfs(), chain.log2_size, chain.levels};
}

// The part of v perpendicular to the unit vector d, normalised.
vec3 beside(vec3 v, vec3 d)
{
    return normalize(v - dot(v, d) * d);
}

// A frame about the unit vector d towards a face. Its tangents bisect the projected directions of the face's sides, so
// that mirrored directions have mirrored frames, alike on all faces.
mat3 frame_on_face(int face, vec3 d)
{
    const vec3 axis = direction_from_cube(face, 0.0, 0.0);
    const vec3 right = beside(direction_from_cube(face, 1.0, 0.0) - axis, d),
               down = beside(direction_from_cube(face, 0.0, 1.0) - axis, d);
    return mat3(normalize(right + down), normalize(right - down), d);
}

} // namespace

HWY_FLATTEN void resample_row(const ResampleRow& row, CubeChain& chain)
{
    const Panorama& p = *row.panorama;
    const PanoramaView panorama_view{reinterpret_cast<const int32_t*>(p.texels.data()), p.width, p.height,
                                     row.limit / p.scale};
    const int size = chain.face_size(0);
    const Real scale = p.scale / chain.scale;
    uint16_t* out = chain.halfs() + 3 * chain.texel(0, row.face, 0, row.y);
    for (int x = row.first; x < row.end; x += static_cast<int>(lane_count)) {
        vec3 sum(0.0);
        Real solid_angles = 0.0; // up to a common factor
        for (const TexelPoint& point : *row.points) {
            const Real t = (static_cast<float>(row.y) + point.y) * 2.0f / static_cast<float>(size) - 1.0f;
            const vec3 d = direction_from_cube(row.face, face_coordinate(x, point.x, size), t);
            const Real inverse = inversesqrt(dot(d, d)), solid_angle = inverse * inverse * inverse;
            sum +=
                solid_angle * panorama_bilinear(panorama_view, equirectangular_from_direction(inverse * d));
            solid_angles += solid_angle;
        }
        store_halfs(scale / solid_angles * sum, lanes_left(x, row.end), out + 3 * x);
    }
}

HWY_FLATTEN void blur_row(const BlurRow& row, CubeChain& chain)
{
    const CubeView source = view(chain);
    const int size = chain.face_size(row.level);
    const Int source_level = integer(row.level - 1);
    const GaussianTaps& taps = *row.taps;
    const Real weight = 1.0f / static_cast<float>(taps.x.size());
    const Real t = (static_cast<float>(row.y) + 0.5f) * 2.0f / static_cast<float>(size) - 1.0f;
    uint16_t* out = chain.halfs() + 3 * chain.texel(row.level, row.face, 0, row.y);
    for (int x = 0; x < size; x += static_cast<int>(lane_count)) {
        const vec3 d = normalize(direction_from_cube(row.face, face_coordinate(x, 0.5f, size), t));
        const mat3 frame = frame_on_face(row.face, d);
        LevelSums sums(source, source_level);
        for (size_t i = 0; i < taps.x.size(); ++i)
            sums.add(frame * vec3(taps.x[i], taps.y[i], taps.z[i]));
        store_halfs(weight * sums.sum(), lanes_left(x, size), out + 3 * x);
    }
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(resample_row);
HWY_EXPORT(blur_row);

void resample_row(const ResampleRow& row, CubeChain& chain)
{
    HWY_DYNAMIC_DISPATCH(resample_row)(row, chain);
}

void blur_row(const BlurRow& row, CubeChain& chain)
{
    HWY_DYNAMIC_DISPATCH(blur_row)(row, chain);
}

} // namespace lambent::environment
#endif
