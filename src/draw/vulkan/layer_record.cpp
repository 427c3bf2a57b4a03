#include "draw/vulkan/layer_record.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <iterator>

namespace lambent::draw {
namespace {

using namespace gpu_layout;

constexpr int background_layer_code = -1;

// A column of the CPU's fragments and where it is on the device.
struct ColumnPair {
    Column here;
    int there;
};

constexpr ColumnPair columns[] = {{base_r, column_base},
                                  {specular_r, column_specular},
                                  {gloss, column_gloss},
                                  {metalness, column_metalness},
                                  {shading_x, column_normal},
                                  {depth, column_depth},
                                  {occlusion, column_occlusion},
                                  {irradiance_r, column_irradiance},
                                  {emitted_r, column_emitted},
                                  {direct_r, column_direct},
                                  {ambient_r, column_ambient},
                                  {reflected_r, column_reflected},
                                  {middle_level, column_middle_level}};

int layer_code(const LayerSource& source)
{
    static_assert(static_cast<int>(Reading::one) == read_one &&
                  static_cast<int>(Reading::three) == read_three &&
                  static_cast<int>(Reading::root) == read_root);
    const auto* const found = std::find_if(std::begin(columns), std::end(columns),
                                           [&](const ColumnPair& pair) { return pair.here == source.first; });
    if (found == std::end(columns))
        throw Error(Failure::no_device, text("the device keeps nothing of the layer ", source.name));
    return 4 * found->there + static_cast<int>(source.reading);
}

void add(int code, PictureRecord& record)
{
    record.layers[record.samples.z / 4][record.samples.z % 4] = code;
    ++record.samples.z;
}

} // namespace

void list_layers(std::span<const LayerSource> sources, PictureRecord& record)
{
    if (sources.size() >= static_cast<std::size_t>(most_layers))
        throw Error(Failure::no_device,
                    text("the device draws at most ", most_layers, " layers, not ", sources.size() + 1));
    std::vector<int> codes;
    for (const LayerSource& source : sources)
        codes.push_back(layer_code(source));
    codes.push_back(background_layer_code);
    for (const int code : codes)
        add(code, record);
}

void list_unlit(PictureRecord& record)
{
    if (record.samples.z >= most_layers)
        throw Error(Failure::no_device, text("the device draws at most ", most_layers, " layers"));
    add(4 * column_emitted + read_unlit, record);
}

} // namespace lambent::draw
