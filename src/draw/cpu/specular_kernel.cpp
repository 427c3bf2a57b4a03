#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/specular_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "albedo/albedo_table.h"
#include "draw/cpu/specular_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::draw::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "draw/cpu/wide_fragments.h"
#include "environment/chain/wide_cube.h"
#include "environment/panorama/wide_panorama.h"

#include "shading/numbers.glsl"

#include "draw/cpu/wide_environment.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // those of other passes
#pragma GCC diagnostic ignored "-Wunused-parameter" // in code made from empty lists
#include "shading/all.glsl"
#include "shading/light_passes.glsl"
#pragma GCC diagnostic pop

} // namespace

HWY_FLATTEN void light_specularly(const LightContext& context, size_t begin, size_t end, Fragments& fragments)
{
    const environment::CubeChain& chain = context.environment->chain;
    CubeSums sums({chain.halfs(), chain.log2_size, chain.levels});
    const Environment e = environment_of(context, &sums);
    for (size_t at = begin; at < end; at += lane_count)
        add_specular(e, fragment(fragments, at));
    if (context.middle_level)
        for (size_t at = begin; at < end; at += lane_count)
            store(fragment(fragments, at), column_middle_level, middle_level(e, fragment(fragments, at)));
}

} // namespace lambent::draw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::draw {

HWY_EXPORT(light_specularly);

void light_specularly(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(light_specularly)(context, begin, end, fragments);
}

} // namespace lambent::draw
#endif
