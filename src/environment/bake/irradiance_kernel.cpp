#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/bake/irradiance_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/bake/irradiance_kernel.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "environment/chain/wide_faces.h"
#include "environment/panorama/wide_panorama.h"

} // namespace

HWY_FLATTEN std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y,
                                                             const AzimuthOrders& orders)
{
    const auto* texels = reinterpret_cast<const int32_t*>(panorama.texels.data()) +
                         static_cast<size_t>(y) * static_cast<size_t>(panorama.width);
    vec3 sums[5] = {vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)};
    alignas(64) int32_t last[max_lanes] = {}; // no light in the lanes beyond the row's end
    for (int x = 0; x < panorama.width; x += static_cast<int>(lane_count)) {
        const size_t count = lanes_left(x, panorama.width);
        if (count < lane_count)
            memcpy(last, texels + x, count * sizeof(int32_t));
        const vec3 c = unpack_texel(hn::LoadU(IntTag(), count < lane_count ? last : texels + x));
        sums[0] += c;
        for (size_t i = 0; i < 4; ++i)
            sums[i + 1] += Real(hn::LoadU(FloatTag(), orders.rows[i].data() + x)) * c;
    }
    std::array<std::array<double, 5>, 3> moments{};
    const auto total = [&](Real r) HWY_ATTR {
        return static_cast<double>(panorama.scale) *
               static_cast<double>(hn::GetLane(hn::SumOfLanes(FloatTag(), r.v)));
    };
    for (size_t i = 0; i < 5; ++i) {
        moments[0][i] = total(sums[i].x);
        moments[1][i] = total(sums[i].y);
        moments[2][i] = total(sums[i].z);
    }
    return moments;
}

HWY_FLATTEN void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map)
{
    const int size = map.face_size(0);
    const Real t = (static_cast<float>(y) + 0.5f) * 2.0f / static_cast<float>(size) - 1.0f;
    uint16_t* out = map.halfs() + 3 * map.texel(0, face, 0, y);
    for (int x = 0; x < size; x += static_cast<int>(lane_count)) {
        const vec3 n = normalize(direction_from_cube(face, face_coordinate(x, 0.5f, size), t));
        Real sums[3] = {0.0, 0.0, 0.0};
        for (size_t i = 0; i < cells.x[0].size(); ++i)
            for (int c = 0; c < 3; ++c)
                sums[c] += max(dot(n, vec3(cells.x[c][i], cells.y[c][i], cells.z[c][i])), 0.0);
        store_halfs(Real(1.0f / map.scale) * vec3(sums[0], sums[1], sums[2]), lanes_left(x, size),
                    out + 3 * x);
    }
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(row_moments);
HWY_EXPORT(irradiance_row);

std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y, const AzimuthOrders& orders)
{
    return HWY_DYNAMIC_DISPATCH(row_moments)(panorama, y, orders);
}

void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map)
{
    HWY_DYNAMIC_DISPATCH(irradiance_row)(cells, face, y, map);
}

} // namespace lambent::environment
#endif
