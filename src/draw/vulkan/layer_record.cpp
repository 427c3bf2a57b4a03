#include "draw/vulkan/layer_record.h"

#include "base/error.h"
#include "base/text.h"

namespace lambent::draw {
namespace {

using namespace gpu_layout;

constexpr int background_layer_code = -1;

int layer_code(const LayerSource& source)
{
    static_assert(static_cast<int>(Reading::one) == read_one &&
                  static_cast<int>(Reading::three) == read_three &&
                  static_cast<int>(Reading::root) == read_root);
    return 4 * source.first + static_cast<int>(source.reading);
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
    add(4 * column_emissive + read_unlit, record);
}

} // namespace lambent::draw
