#include "draw/vulkan/device_prefilter.h"

#include "draw/vulkan/filled_buffer.h"
#include "gpu_layout/layout.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cstring>

namespace lambent::draw {
namespace {

using namespace gpu_layout;
using environment::FaceTile, environment::LightCell, environment::LightTree, environment::Prefilter,
    environment::PrefilteredFaces;

constexpr std::uint32_t code[] =
#include "vulkan/prefilter.comp.spv.inc"
    ;

// A light cell in the layout that the shader reads.
struct CellRecord {
    vec4 place, light;
};

CellRecord record_of(const LightCell& cell, float area)
{
    return {{cell.x, cell.y, cell.z, cell.variance}, {cell.r, cell.g, cell.b, area}};
}

// A tree's cells by depth, then the areas whose centroid differs from that of the light.
struct TreeRecords {
    std::vector<CellRecord> cells;
    std::vector<ivec4> levels;

    explicit TreeRecords(const LightTree& tree)
    {
        ivec4 next(0);
        for (const environment::LightCellLevel& level : tree.levels()) {
            next.z = level.width;
            next.w = level.height;
            levels.push_back(next);
            next.x += level.width * level.height;
            next.y += level.height;
        }
        cells.resize(static_cast<std::size_t>(next.x));
        for (std::size_t depth = 0; depth < levels.size(); ++depth)
            add(tree, depth);
    }

private:
    void add(const LightTree& tree, std::size_t depth)
    {
        const ivec4& level = levels[depth];
        const auto place = [&](int row, int column) {
            return static_cast<std::size_t>(level.x) +
                   static_cast<std::size_t>(row) * static_cast<std::size_t>(level.z) +
                   static_cast<std::size_t>(column);
        };
        tbb::parallel_for(0, level.w, [&](int row) {
            for (int column = 0; column < level.z; ++column) {
                const LightCell cell = tree.cell(depth, column, row);
                cells[place(row, column)] = record_of(cell, cell.area);
            }
        });
        for (int row = 0; row < level.w; ++row)
            for (int column = 0; column < level.z; ++column)
                if (CellRecord& cell = cells[place(row, column)]; !(cell.light.w > 0.0f)) {
                    const LightCell& area = tree.area(depth, column, row);
                    cell.light.w = -1.0f - static_cast<float>(cells.size());
                    cells.push_back(record_of(area, area.area)); // `cell` is no longer valid
                }
    }
};

std::vector<vec4> bounds_of(const Prefilter& prefilter)
{
    std::vector<vec4> records;
    for (const std::vector<Prefilter::Bounds>& rows : prefilter.bounds())
        for (const Prefilter::Bounds& row : rows)
            records.push_back({row.far, row.far_bright, row.reach, row.fine_at_horizon ? 1.0f : 0.0f});
    return records;
}

// The texel tiles of all levels, and the bounds of rows of cells for their lobes.
struct Work {
    std::vector<vec4> directions, bounds;
    std::vector<BakeConstants> constants;
    std::vector<std::vector<FaceTile>> tiles;

    void add(const PrefilteredFaces& faces)
    {
        const Prefilter& prefilter = faces.prefilter;
        const environment::PrefilterLobe& lobe = prefilter.lobe();
        const double shape = lobe.phong ? lobe.exponent : lobe.alpha * lobe.alpha;
        constants.push_back({{static_cast<float>(shape), static_cast<float>(lobe.integral()),
                              prefilter.much_light(), prefilter.bright_radiance()},
                             {static_cast<int>(directions.size() / 64), static_cast<int>(bounds.size()),
                              static_cast<int>(prefilter.tree().levels().size()), 0}});
        const std::vector<vec4> rows = bounds_of(prefilter);
        bounds.insert(bounds.end(), rows.begin(), rows.end());
        tiles.push_back(face_tiles(faces));
        for (const FaceTile& tile : tiles.back())
            for (const float* d : tile.directions)
                directions.emplace_back(d[0], d[1], d[2], 0.0f);
    }
};

// Copies results to the cube, without the padding of tiles.
void take(const std::vector<FaceTile>& tiles, const vec4* results, const PrefilteredFaces& faces)
{
    const int size = faces.cube.face_size(faces.level);
    for (const FaceTile& tile : tiles)
        for (int i = 0; i < 64; ++i, ++results) {
            const int x = tile.x + i % 8, y = tile.y + i / 8;
            if (x < size && y < size)
                std::memcpy(faces.cube.pixel(faces.level, tile.face, x, y), results, 3 * sizeof(float));
        }
}

} // namespace

DevicePrefilter::DevicePrefilter(const VulkanOptions& options)
    : instance_(options.validation),
      device_(instance_, vulkan::choose(instance_.devices(),
                                        options.software ? vulkan::Choice::any : vulkan::Choice::hardware)),
      cache_(device_, options.cache_folder.empty() ? std::filesystem::path()
                                                   : options.cache_folder / "bake_shaders.bin"),
      layout_(device_, std::vector<vulkan::Binding>(bake_binding_count, vulkan::Binding::storage_buffer),
              sizeof(BakeConstants))
{
}

DevicePrefilter::~DevicePrefilter() = default;

const vulkan::ComputePipeline& DevicePrefilter::pipeline(bool phong)
{
    std::unique_ptr<vulkan::ComputePipeline>& made = pipelines_[phong ? 1 : 0];
    const std::array constants = {static_cast<uint>(phong ? bake_lobe_phong : bake_lobe_ggx)};
    if (!made)
        made = std::make_unique<vulkan::ComputePipeline>(cache_, layout_, code, constants);
    return *made;
}

void DevicePrefilter::fill(const std::vector<PrefilteredFaces>& faces,
                           const std::function<void(double)>& report)
{
    if (faces.empty())
        return;
    const TreeRecords tree(faces.front().prefilter.tree());
    Work work;
    for (const PrefilteredFaces& one : faces)
        work.add(one);
    const vulkan::Buffer cells = filled_buffer(device_, tree.cells),
                         levels = filled_buffer(device_, tree.levels),
                         bounds = filled_buffer(device_, work.bounds),
                         directions = filled_buffer(device_, work.directions);
    const std::size_t bytes = work.directions.size() * sizeof(vec4);
    const vulkan::Buffer results(device_, bytes,
                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                 vulkan::MemoryKind::device),
        back(device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::MemoryKind::readback);
    std::array<vulkan::Resource, bake_binding_count> resources{};
    resources[bake_cells].buffer = &cells;
    resources[bake_bounds].buffer = &bounds;
    resources[bake_levels].buffer = &levels;
    resources[bake_directions].buffer = &directions;
    resources[bake_results].buffer = &results;
    const vulkan::BindingSet set(device_, layout_, resources);
    vulkan::Commands commands(device_);
    commands.lap("prefilter");
    for (std::size_t i = 0; i < faces.size(); ++i)
        commands.dispatch(pipeline(faces[i].prefilter.lobe().phong), set,
                          std::as_bytes(std::span(&work.constants[i], 1)),
                          {static_cast<std::uint32_t>(work.tiles[i].size()), 1, 1});
    commands.lap("readback");
    commands.copy(results, back, bytes);
    commands.run();
    milliseconds_.push_back(commands.laps().front().second);
    cache_.keep();
    instance_.require_no_validation_messages();
    const auto* from = reinterpret_cast<const vec4*>(back.memory().data());
    for (std::size_t i = 0; i < faces.size(); from += 64 * work.tiles[i].size(), ++i)
        take(work.tiles[i], from, faces[i]);
    if (report)
        report(1.0);
}

} // namespace lambent::draw
