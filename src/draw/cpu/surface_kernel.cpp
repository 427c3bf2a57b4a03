#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/surface_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "albedo/albedo_table.h"
#include "draw/cpu/surface_kernel.h"

#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::draw::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "shading/numbers.glsl"
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // Embree intersects triangles
#include "shading/points.glsl"
#pragma GCC diagnostic pop
#include "draw/cpu/wide_fragments.h"
#include "draw/cpu/wide_texture.h"

#include "draw/cpu/wide_sources.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // those of the light passes
#pragma GCC diagnostic ignored "-Wunused-parameter" // in code made from empty lists
#include "shading/surface_pass.glsl"
#pragma GCC diagnostic pop

static_assert(albedo_points == albedo_table_size);
static_assert(static_cast<int>(scene::AlphaMode::opaque) == alpha_opaque &&
              static_cast<int>(scene::AlphaMode::mask) == alpha_mask &&
              static_cast<int>(scene::AlphaMode::blend) == alpha_blend);

} // namespace

HWY_FLATTEN void find_surfaces(const SurfaceContext& context, size_t begin, size_t end, Fragments& fragments)
{
    for (size_t at = begin; at < end; at += lane_count) {
        const Fragment f = fragment(fragments, at);
        find_surface(f, {&context, f, fragments.triangle.data() + at}, load(f, extent));
    }
}

} // namespace lambent::draw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::draw {

HWY_EXPORT(find_surfaces);

void find_surfaces(const SurfaceContext& context, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(find_surfaces)(context, begin, end, fragments);
}

} // namespace lambent::draw
#endif
