#include "draw/vulkan/picture_passes.h"

#include "draw/reach.h"
#include "draw/layer_list.h"
#include "draw/vulkan/layer_record.h"
#include "draw/vulkan/raster_map.h"

#include <algorithm>
#include <cstring>

namespace lambent::draw {
namespace {

using namespace gpu_layout;
using vulkan::Commands, vulkan::Groups;

// The layer of unlit surfaces, if there are any, comes last.
void describe_layers(const Settings& settings, bool has_unlit, PictureRecord& record)
{
    if (settings.layers)
        list_layers(layer_sources(settings.model), record);
    if (has_unlit)
        list_unlit(record);
}

void describe_rays(const RayMap& rays, PictureRecord& record)
{
    record.origin = vec4(rays.origin, 0.0f);
    record.origin_dx = vec4(rays.origin_dx, 0.0f);
    record.origin_dy = vec4(rays.origin_dy, 0.0f);
    record.direction = vec4(rays.direction, 0.0f);
    record.direction_dx = vec4(rays.direction_dx, 0.0f);
    record.direction_dy = vec4(rays.direction_dy, 0.0f);
}

template <class Record>
std::span<const std::byte> bytes_of(const Record& record)
{
    return std::as_bytes(std::span(&record, 1));
}

// Workgroups of 8x8 pixels.
Groups blocks(const ivec4& area)
{
    return {static_cast<std::uint32_t>(area.z + 7) / 8, static_cast<std::uint32_t>(area.w + 7) / 8, 1};
}

constexpr std::array<std::byte, sizeof(RasterConstants)> no_constants{};

} // namespace

void add_lap(const Lap& lap, std::vector<Lap>& laps)
{
    const auto found =
        std::find_if(laps.begin(), laps.end(), [&](const Lap& other) { return other.first == lap.first; });
    if (found == laps.end())
        laps.push_back(lap);
    else
        found->second += lap.second;
}

std::vector<glm::vec2> look_places(const Edges& edges)
{
    std::vector<glm::vec2> places;
    if (edges.places.size() > 1)
        places = edges.places;
    places.emplace_back(0.5f, 0.5f);
    return places;
}

PicturePasses::PicturePasses(const DeviceTools& tools, const PreparedPicture& picture,
                             const scene::Bounds& bounds)
    : tools_(tools), prepared_(picture), bounds_(bounds), looks_(look_places(picture.edges)),
      picture_(tools.device, picture.light, picture.few_tables, picture.lights), record_(picture_.record()),
      has_background_(describe_background(tools.device, picture, tools.environment, record_)), set_(bind())
{
    tools_.tile.place_looks(looks_);
    describe_rays(picture.rays, record_);
    describe_layers(picture.settings, tools.scene.has_unlit(), record_);
    record_.fragments.x = static_cast<int>(tools.tile.shape().capacity);
    record_.surfaces.x = picture.settings.roughness_override.value_or(-1.0f);
    record_.surfaces.y = picture.settings.model == Model::phong ? 1.0f : 0.0f;
    record_.edges = {picture.edges.bend_cosine, picture.edges.shared_cosine, picture.edges.extent, 0.0f};
    record_.corners = {picture.edges.corners[0], picture.edges.corners[1], picture.edges.corners[2],
                       picture.edges.corners[3]};
    const VkDeviceAddress geometry = tools.scene.geometry().address();
    record_.addresses.x = static_cast<uint>(geometry);
    record_.addresses.y = static_cast<uint>(geometry >> 32);
}

vulkan::BindingSet PicturePasses::bind() const
{
    std::array<vulkan::Resource, binding_count> resources{};
    picture_.offer(resources);
    tools_.environment.offer(resources);
    tools_.tile.offer(resources);
    resources[binding_instances].buffer = &tools_.scene.instances();
    resources[binding_meshes].buffer = &tools_.scene.meshes();
    resources[binding_materials].buffer = &tools_.scene.materials();
    resources[binding_textures].buffer = &tools_.scene.textures();
    resources[binding_codes].buffer = &tools_.scene.codes();
    return {tools_.device, tools_.layout, resources};
}

// Sets the tile and its apron, which includes the pixels around it that edge detection reads.
void PicturePasses::describe(const PictureArea& area)
{
    const Settings& settings = prepared_.settings;
    const int x = std::max(area.x - 1, 0), y = std::max(area.y - 1, 0);
    record_.tile = {area.x, area.y, area.width, area.height};
    record_.apron = {x, y, std::min(area.x + area.width + 1, settings.width) - x,
                     std::min(area.y + area.height + 1, settings.height) - y};
}

void PicturePasses::draw_triangles(int wave, Commands& commands)
{
    const ivec4& apron = record_.apron;
    const bool in_reach = within_reach(prepared_.rays);
    for (std::size_t look = 0; look < looks_.size(); ++look) {
        const RasterWindow window = {apron.x, apron.y, apron.z, apron.w, looks_[look]};
        std::optional<RasterConstants> map;
        if (in_reach)
            map = raster_map(prepared_.rays, window, bounds_);
        RasterConstants constants = map.value_or(RasterConstants{});
        constants.look.x = static_cast<int>(look);
        const vulkan::RasterTarget target = {tools_.passes.triangles(wave),
                                             tools_.scene.positions(),
                                             tools_.scene.indices(),
                                             tools_.tile.ids(),
                                             tools_.tile.depth(),
                                             static_cast<std::uint32_t>(look),
                                             static_cast<std::uint32_t>(apron.z),
                                             static_cast<std::uint32_t>(apron.w),
                                             nothing};
        const std::span<const vulkan::DrawBatch> all(tools_.scene.batches());
        commands.draw(target, set_, bytes_of(constants), map ? all : all.first(0));
    }
}

void PicturePasses::light(Commands& commands)
{
    const auto add = [&](const char* name, int pass) {
        commands.lap(name);
        commands.dispatch_indirect(tools_.passes.light(pass), set_, no_constants,
                                   {tools_.tile.counters(), 0});
    };
    if (!prepared_.lights.empty())
        add("direct", pass_direct);
    if (!prepared_.light.environment)
        return;
    add("ambient", pass_ambient);
    add("specular", pass_specular);
}

void PicturePasses::count_anew(Commands& commands, int first) const
{
    constexpr std::array<uint, 4> none = {0, 1, 1, 0};
    commands.write(tools_.tile.counters(), std::as_bytes(std::span(none)),
                   static_cast<VkDeviceSize>(first) * sizeof(uint));
}

// Makes fragments of the surfaces that the looks see.
void PicturePasses::find_fragments(int wave, Commands& commands)
{
    Passes& passes = tools_.passes;
    const vulkan::Buffer& counters = tools_.tile.counters();
    count_anew(commands, counter_fragment_groups);
    commands.lap("edges");
    if (wave == 0) {
        count_anew(commands, counter_listed_groups);
        commands.dispatch(passes.seen(), set_, no_constants, blocks(record_.apron));
        commands.dispatch(passes.edges(), set_, no_constants, blocks(record_.tile));
    }
    if (wave > 0 || looks_.size() > 1)
        commands.dispatch_indirect(passes.gather(wave), set_, no_constants,
                                   {counters, counter_listed_groups * sizeof(uint)});
    count_anew(commands, counter_listed_groups);
}

void PicturePasses::draw_wave(int wave, Commands& commands)
{
    Passes& passes = tools_.passes;
    const vulkan::Buffer& counters = tools_.tile.counters();
    commands.lap("triangles");
    draw_triangles(wave, commands);
    find_fragments(wave, commands);
    commands.lap("surfaces");
    commands.dispatch_indirect(passes.surfaces(), set_, no_constants, {counters, 0});
    light(commands);
    commands.lap("resolve");
    commands.dispatch(passes.resolve(wave), set_, no_constants, blocks(record_.tile));
    commands.copy(counters, tools_.tile.counted(), counter_count * sizeof(uint));
}

void PicturePasses::finish(Commands& commands)
{
    if (has_background_) {
        commands.lap("background");
        commands.dispatch(tools_.passes.background(), set_, no_constants, blocks(record_.tile));
    }
    commands.lap("readback");
    const auto values = static_cast<VkDeviceSize>(record_.tile.z) *
                        static_cast<VkDeviceSize>(record_.tile.w) *
                        static_cast<VkDeviceSize>(1 + record_.samples.z);
    commands.copy(tools_.tile.output(), tools_.tile.drawn(), values * sizeof(vec4));
}

std::uint32_t PicturePasses::counted(int counter) const
{
    std::uint32_t count = 0;
    std::memcpy(&count,
                tools_.tile.counted().memory().data() + static_cast<std::size_t>(counter) * sizeof count,
                sizeof count);
    return count;
}

void PicturePasses::run(Commands& commands)
{
    commands.run();
    for (const Lap& lap : commands.laps())
        add_lap(lap, times_);
}

// Returns whether the tile's fragments fitted in their buffers.
bool PicturePasses::draw_tile(const PictureArea& area)
{
    describe(area);
    const auto had_room = [&] { return counted(counter_fragments) <= tools_.tile.shape().capacity; };
    Commands first(tools_.device);
    first.write(tools_.tile.picture(), bytes_of(record_));
    draw_wave(0, first);
    if (!tools_.scene.transparent()) {
        finish(first);
        run(first);
        return had_room();
    }
    run(first);
    if (!had_room())
        return false;
    for (int wave = 1; wave < most_waves && counted(counter_listed) > 0; ++wave) {
        Commands next(tools_.device);
        draw_wave(1, next);
        run(next);
    }
    Commands last(tools_.device);
    finish(last);
    run(last);
    return true;
}

void PicturePasses::draw(const PictureArea& area, Frame& frame)
{
    if (draw_tile(area)) {
        copy_to(area, frame);
        return;
    }
    PictureArea half = area, other = area;
    if (area.height > 1) {
        half.height = area.height / 2;
        other.y += half.height, other.height -= half.height;
    } else {
        half.width = area.width / 2;
        other.x += half.width, other.width -= half.width;
    }
    draw(half, frame);
    draw(other, frame);
}

void PicturePasses::copy_to(const PictureArea& area, Frame& frame) const
{
    const std::byte* from = tools_.tile.drawn().memory().data();
    const std::size_t row = static_cast<std::size_t>(area.width) * sizeof(vec4);
    const auto copy = [&](std::vector<float>& values) {
        for (int y = 0; y < area.height; ++y, from += row) {
            const auto at =
                static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(frame.radiance.width) +
                static_cast<std::size_t>(area.x);
            std::memcpy(values.data() + 4 * at, from, row);
        }
    };
    copy(frame.radiance.values);
    for (Layer& layer : frame.layers)
        copy(layer.image.values);
    if (!frame.radiance.unlit.empty())
        copy(frame.radiance.unlit);
}

} // namespace lambent::draw
