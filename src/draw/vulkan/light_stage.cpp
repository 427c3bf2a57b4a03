#include "draw/vulkan/light_stage.h"

#include "environment/albedo_table.h"
#include "gpu_layout/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace lambent::draw {
namespace {

constexpr std::uint32_t shader[] =
#include "vulkan/light.comp.spv.inc"
    ;

using namespace gpu_layout;
using vulkan::Binding, vulkan::Buffer, vulkan::Place;

// A column of the CPU's fragments and where it is on the device; `count` columns in a row.
struct Columns {
    Column here;
    int there, count;
};

constexpr Columns given[] = {{position_x, column_position, 3},       {view_x, column_view, 3},
                             {shading_x, column_normal, 3},          {mirrored_dx_x, column_mirrored_dx, 3},
                             {mirrored_dy_x, column_mirrored_dy, 3}, {base_r, column_base, 3},
                             {specular_r, column_specular, 3},       {gloss, column_gloss, 1},
                             {metalness, column_metalness, 1},       {occlusion, column_occlusion, 1}};
constexpr Columns lit[] = {
    {irradiance_r, column_irradiance, 3}, {ambient_r, column_ambient, 3}, {reflected_r, column_reflected, 3}};
constexpr Columns direct = {direct_r, column_direct, 3};

LightRecord record_of(const LightSource& light)
{
    LightRecord record{};
    record.position_local = vec4(light.position, light.local ? 1.0f : 0.0f);
    record.intensity_range = vec4(light.intensity, light.local ? 1.0f / light.range : 0.0f);
    record.axis_inner = vec4(light.axis, light.cos_inner);
    record.outer.x = light.cos_outer;
    return record;
}

template <class Record>
std::span<const std::byte> bytes_of(const std::vector<Record>& records)
{
    return std::as_bytes(std::span(records));
}

std::vector<Binding> bindings()
{
    std::vector<Binding> bindings(binding_count, Binding::storage_buffer);
    bindings[binding_chain] = bindings[binding_irradiance] = Binding::sampled_cube;
    bindings[binding_mips] = Binding::sampled_picture;
    return bindings;
}

} // namespace

struct LightStage::Pass {
    const char* name;
    bool needs_environment;
    vulkan::ComputePipeline pipeline;
};

struct LightStage::Room {
    std::size_t capacity;
    Buffer up, values, picture, back;
    std::vector<std::unique_ptr<vulkan::BindingSet>> sets; // of each pass

    Room(const vulkan::Device& device, std::size_t count)
        : capacity(count), up(device, bytes(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Place::upload),
          values(device, bytes(),
                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                     VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                 Place::device),
          picture(device, sizeof(PictureRecord), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Place::upload),
          back(device, bytes(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, Place::readback)
    {
    }

    VkDeviceSize bytes() const { return capacity * column_count * sizeof(float); }
};

LightStage::LightStage(const vulkan::Device& device, const vulkan::PipelineCache& cache,
                       const LightContext& context, std::span<const LightSource> lights)
    : device_(device), context_(context),
      environment_(device, context.environment,
                   context.mip_chain && !context.mip_chain->empty() ? context.mip_chain : nullptr),
      light_count_(static_cast<int>(lights.size()))
{
    make_passes(cache);
    fill_tables(lights);
}

LightStage::~LightStage() = default;

void LightStage::make_passes(const vulkan::PipelineCache& cache)
{
    const auto model = static_cast<std::uint32_t>(context_.model == Model::phong ? model_phong : model_ggx);
    const auto levels =
        static_cast<std::uint32_t>(context_.mip_level == MipLevel::report ? levels_report : levels_matched);
    const auto add = [&](const char* name, int pass, bool needs_environment) {
        const vulkan::ComputeShader code{
            shader, bindings(), 0, {static_cast<std::uint32_t>(pass), model, levels}};
        passes_.push_back(std::unique_ptr<Pass>(new Pass{name, needs_environment, {device_, cache, code}}));
    };
    add("direct", pass_direct, false);
    add("ambient", pass_ambient, true);
    add("specular", pass_specular, true);
}

Buffer LightStage::filled(std::span<const std::byte> bytes) const
{
    // No buffer is empty.
    Buffer buffer(device_, std::max<std::size_t>(bytes.size(), 64), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                  Place::upload);
    std::copy(bytes.begin(), bytes.end(), buffer.memory().begin());
    return buffer;
}

void LightStage::fill_tables(std::span<const LightSource> lights)
{
    std::vector<LightRecord> sources(lights.size());
    std::transform(lights.begin(), lights.end(), sources.begin(), record_of);
    lights_.emplace(filled(bytes_of(sources)));

    const SampleTables& tables = *context_.tables;
    std::vector<SampleRecord> points(tables.cap.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].cap = {tables.cap[i].xi2, tables.cap[i].cosine, tables.cap[i].sine, tables.pixel[i].x};
        points[i].lobe = {tables.lobe[i].log2_xi2, tables.lobe[i].cosine, tables.lobe[i].sine,
                          tables.pixel[i].y};
    }
    samples_.emplace(filled(bytes_of(points)));

    std::vector<LampRecord> lamps;
    if (context_.environment)
        for (const environment::Lamp& lamp : context_.environment->lamps.lamps)
            lamps.push_back({{lamp.direction[0], lamp.direction[1], lamp.direction[2], 0.0f},
                             {lamp.light[0], lamp.light[1], lamp.light[2], 0.0f}});
    lamps_.emplace(filled(bytes_of(lamps)));
    albedo_.emplace(filled(std::as_bytes(std::span(environment::albedo_table))));
}

void LightStage::make_room(std::size_t count)
{
    if (room_ && room_->capacity >= count)
        return;
    room_.reset();
    room_ = std::make_unique<Room>(device_, count);
    std::array<vulkan::Resource, binding_count> resources{};
    resources[binding_fragments].buffer = &room_->values;
    resources[binding_picture].buffer = &room_->picture;
    resources[binding_lights].buffer = &*lights_;
    resources[binding_samples].buffer = &*samples_;
    resources[binding_lamps].buffer = &*lamps_;
    resources[binding_albedo].buffer = &*albedo_;
    resources[binding_chain] = environment_.chain();
    resources[binding_irradiance] = environment_.irradiance();
    resources[binding_mips] = environment_.mips();
    for (const std::unique_ptr<Pass>& pass : passes_)
        room_->sets.push_back(std::make_unique<vulkan::BindingSet>(device_, pass->pipeline, resources));
}

namespace {

PictureRecord picture_of(const LightContext& c, std::size_t capacity, std::size_t count, int lights)
{
    PictureRecord p{};
    p.across = vec4(c.across, 0.0f);
    p.rotation = {c.rotation_cosine, c.rotation_sine, c.ambient_brightness,
                  c.energy_compensation ? 1.0f : 0.0f};
    p.fragments = {static_cast<int>(capacity), static_cast<int>(count), lights, 0};
    p.samples = {static_cast<int>(c.tables->cap.size()), environment::albedo_table_size, 0, 0};
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

} // namespace

void LightStage::light(Fragments& fragments)
{
    const std::size_t count = fragments.size();
    make_room(count);
    const PictureRecord picture = picture_of(context_, room_->capacity, count, light_count_);
    std::memcpy(room_->picture.memory().data(), &picture, sizeof picture);
    auto* const up = reinterpret_cast<float*>(room_->up.memory().data());
    for (const Columns& columns : given)
        for (int i = 0; i < columns.count; ++i)
            std::copy_n(fragments[Column(columns.here + static_cast<std::size_t>(i))], count,
                        up + static_cast<std::size_t>(columns.there + i) * room_->capacity);

    vulkan::Commands commands(device_);
    commands.lap("upload");
    commands.copy(room_->up, room_->values, room_->bytes());
    const std::uint32_t groups =
        (static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(group_size) - 1) /
        static_cast<std::uint32_t>(group_size);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        if (passes_[i]->needs_environment && !context_.environment)
            continue;
        commands.lap(passes_[i]->name);
        commands.dispatch(passes_[i]->pipeline, *room_->sets[i], {}, {groups, 1, 1});
    }
    commands.lap("readback");
    commands.copy(room_->values, room_->back, room_->bytes());
    commands.run();
    laps_ = commands.laps();

    const auto* const back = reinterpret_cast<const float*>(room_->back.memory().data());
    const auto take = [&](const Columns& columns) {
        for (int i = 0; i < columns.count; ++i)
            std::copy_n(back + static_cast<std::size_t>(columns.there + i) * room_->capacity, count,
                        fragments[Column(columns.here + static_cast<std::size_t>(i))]);
    };
    take(direct);
    if (context_.environment)
        for (const Columns& columns : lit)
            take(columns);
}

} // namespace lambent::draw
