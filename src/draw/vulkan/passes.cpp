#include "draw/vulkan/passes.h"

#include "gpu_layout/layout.h"

#include <array>

namespace lambent::draw {
namespace {

using namespace gpu_layout;

constexpr std::uint32_t ids_vertex[] =
#include "vulkan/ids.vert.spv.inc"
    ;
constexpr std::uint32_t ids_fragment[] =
#include "vulkan/ids.frag.spv.inc"
    ;
constexpr std::uint32_t seen_code[] =
#include "vulkan/seen.comp.spv.inc"
    ;
constexpr std::uint32_t edges_code[] =
#include "vulkan/edges.comp.spv.inc"
    ;
constexpr std::uint32_t gather_code[] =
#include "vulkan/gather.comp.spv.inc"
    ;
constexpr std::uint32_t surface_code[] =
#include "vulkan/surface.comp.spv.inc"
    ;
constexpr std::uint32_t light_code[] =
#include "vulkan/light.comp.spv.inc"
    ;
constexpr std::uint32_t resolve_code[] =
#include "vulkan/resolve.comp.spv.inc"
    ;
constexpr std::uint32_t background_code[] =
#include "vulkan/background.comp.spv.inc"
    ;

uint model_of(const PassChoice& choice)
{
    return static_cast<uint>(choice.model == Model::phong ? model_phong : model_ggx);
}

} // namespace

std::unique_ptr<vulkan::ShaderLayout> pass_layout(const vulkan::Device& device)
{
    using vulkan::Binding;
    std::vector<Binding> bindings(binding_count, Binding::storage_buffer);
    bindings[binding_chain] = bindings[binding_irradiance] = Binding::sampled_cube;
    bindings[binding_mips] = Binding::sampled_image;
    bindings[binding_ids] = Binding::sampled_array;
    return std::make_unique<vulkan::ShaderLayout>(device, bindings, sizeof(RasterConstants));
}

Passes::Passes(const vulkan::PipelineCache& cache, const vulkan::ShaderLayout& layout,
               const PassChoice& choice)
    : cache_(cache), layout_(layout), choice_(choice)
{
}

const vulkan::ComputePipeline& Passes::made(Compute& place, vulkan::Spirv code,
                                            vulkan::Constants constants) const
{
    if (!place)
        place = std::make_unique<vulkan::ComputePipeline>(cache_, layout_, code, constants);
    return *place;
}

const vulkan::RasterPipeline& Passes::triangles(int wave)
{
    static_assert(constant_looks == 0 && constant_wave == 1);
    const std::array constants = {static_cast<uint>(choice_.looks), static_cast<uint>(wave)};
    std::unique_ptr<vulkan::RasterPipeline>& place = triangles_[wave];
    if (!place)
        place = std::make_unique<vulkan::RasterPipeline>(
            cache_, layout_,
            vulkan::RasterShader{ids_vertex, ids_fragment, constants, id_format, depth_format,
                                 3 * sizeof(float)});
    return *place;
}

const vulkan::ComputePipeline& Passes::seen()
{
    const std::array constants = {static_cast<uint>(choice_.looks)};
    return made(seen_, seen_code, constants);
}

const vulkan::ComputePipeline& Passes::edges()
{
    const std::array constants = {static_cast<uint>(choice_.looks)};
    return made(edges_, edges_code, constants);
}

const vulkan::ComputePipeline& Passes::gather(int wave)
{
    const std::array constants = {static_cast<uint>(choice_.looks), static_cast<uint>(wave)};
    return made(gather_[wave], gather_code, constants);
}

const vulkan::ComputePipeline& Passes::surfaces()
{
    static_assert(constant_model == 1 && constant_textured == 2 && constant_layered == 3);
    const std::array constants = {0u, model_of(choice_), choice_.textured ? 1u : 0u,
                                  choice_.layered ? 1u : 0u};
    return made(surfaces_, surface_code, constants);
}

const vulkan::ComputePipeline& Passes::light(int pass)
{
    static_assert(constant_pass == 0 && constant_levels == 2 && constant_layered == 3);
    const int levels = choice_.is_pipeline                     ? levels_pipeline
                       : choice_.mip_level == MipLevel::report ? levels_report
                                                               : levels_matched;
    const std::array constants = {static_cast<uint>(pass), model_of(choice_), static_cast<uint>(levels),
                                  choice_.layered ? 1u : 0u};
    return made(light_[pass], light_code, constants);
}

const vulkan::ComputePipeline& Passes::resolve(int wave)
{
    static_assert(constant_through == 2);
    const std::array constants = {static_cast<uint>(choice_.looks), static_cast<uint>(wave),
                                  choice_.through ? 1u : 0u};
    return made(resolve_[wave], resolve_code, constants);
}

const vulkan::ComputePipeline& Passes::background()
{
    const std::array constants = {static_cast<uint>(choice_.looks), 0u, choice_.through ? 1u : 0u};
    return made(background_, background_code, constants);
}

} // namespace lambent::draw
