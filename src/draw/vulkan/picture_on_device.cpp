#include "draw/vulkan/picture_on_device.h"

#include "draw/vulkan/filled_buffer.h"
#include "albedo/albedo_table.h"

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

using namespace gpu_layout;

std::vector<LightRecord> records_of(std::span<const LightSource> lights)
{
    std::vector<LightRecord> records;
    for (const LightSource& light : lights) {
        const bool limited = light.local && std::isfinite(light.range);
        LightRecord record{};
        record.position_local = vec4(light.position, light.local ? 1.0f : 0.0f);
        record.intensity_range = vec4(light.intensity, light.local ? 1.0f / light.range : 0.0f);
        record.axis_inner = vec4(light.axis, light.cos_inner);
        record.outer = {light.cos_outer, limited ? light.range * light.range : -1.0f, 0.0f, 0.0f};
        records.push_back(record);
    }
    return records;
}

void append(const SampleTables& tables, std::vector<SampleRecord>& records)
{
    for (std::size_t i = 0; i < tables.cap.size(); ++i) {
        const SampleTables::Cap& cap = tables.cap[i];
        const SampleTables::Lobe& lobe = tables.lobe[i];
        records.push_back({{cap.xi2, cap.cosine, cap.sine, tables.pixel[i].x},
                           {lobe.log2_xi2, lobe.cosine, lobe.sine, tables.pixel[i].y}});
    }
}

std::vector<SampleRecord> records_of(const SampleTables& tables, const SampleTables& few_tables)
{
    std::vector<SampleRecord> records;
    append(tables, records);
    append(few_tables, records);
    return records;
}

std::vector<LampRecord> records_of(const environment::Environment* environment)
{
    std::vector<LampRecord> records;
    if (environment)
        for (const environment::Lamp& lamp : environment->lamps.lamps)
            records.push_back({{lamp.direction[0], lamp.direction[1], lamp.direction[2], lamp.variance},
                               {lamp.light[0], lamp.light[1], lamp.light[2], 0.0f}});
    return records;
}

PictureRecord record_of(const LightContext& c, std::size_t few_samples, std::size_t lights)
{
    PictureRecord p{};
    p.across = vec4(c.across, 0.0f);
    p.rotation = {c.rotation_cosine, c.rotation_sine, c.ambient_brightness,
                  c.energy_compensation ? 1.0f : 0.0f};
    p.fragments.z = static_cast<int>(lights);
    p.samples = {static_cast<int>(c.tables->cap.size()), albedo_table_size, 0, static_cast<int>(few_samples)};
    if (c.pipeline) {
        p.panorama.y = 1.0f;
        p.report = {c.pipeline->decode, c.pipeline->exposure, c.pipeline->encode, c.pipeline->back};
    }
    if (!c.environment)
        return p;
    const environment::CubeChain& chain = c.environment->chain;
    const environment::Lamps& lamps = c.environment->lamps;
    const float deviation = environment::level_one_deviation(chain);
    p.chain = {chain.scale, deviation * deviation, environment::level_variance(chain, lamps.last_level),
               environment::level_variance(chain, lamps.last_level + 1)};
    p.maps.x = c.environment->irradiance.scale;
    p.fragments.w = static_cast<int>(lamps.lamps.size());
    if (c.mip_chain && !c.mip_chain->empty())
        p.maps.y = 0.5f * std::log2(static_cast<float>(c.mip_chain->front().width) *
                                    static_cast<float>(c.mip_chain->front().height));
    return p;
}

std::vector<float> albedo_values()
{
    return {std::begin(albedo_table), std::end(albedo_table)};
}

} // namespace

PictureOnDevice::PictureOnDevice(const vulkan::Device& device, const LightContext& context,
                                 const SampleTables& few_tables, std::span<const LightSource> lights)
    : record_(record_of(context, few_tables.cap.size(), lights.size())),
      lights_(filled_buffer(device, records_of(lights))),
      samples_(filled_buffer(device, records_of(*context.tables, few_tables))),
      lamps_(filled_buffer(device, records_of(context.environment))),
      albedo_(filled_buffer(device, albedo_values()))
{
}

void PictureOnDevice::offer(std::array<vulkan::Resource, binding_count>& resources) const
{
    resources[binding_lights].buffer = &lights_;
    resources[binding_samples].buffer = &samples_;
    resources[binding_lamps].buffer = &lamps_;
    resources[binding_albedo].buffer = &albedo_;
}

} // namespace lambent::draw
