// The layers that shaders are told of: as many as there is room for, and no more.
#include "base/error.h"
#include "draw/vulkan/layer_record.h"

#include <gtest/gtest.h>

namespace lambent::draw {
namespace {

using namespace gpu_layout;

std::vector<LayerSource> copies(std::size_t count)
{
    return std::vector<LayerSource>(count,
                                    {"normal", Layer::Kind::normal, draw::column_shine, Reading::three});
}

TEST(LayerRecord, HoldsAsManyAsThereIsRoomFor)
{
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{most_layers - 1}}) {
        PictureRecord record{};
        list_layers(copies(count), record);
        ASSERT_EQ(record.samples.z, static_cast<int>(count) + 1);
        for (int i = 0; i < static_cast<int>(count); ++i)
            EXPECT_EQ(record.layers[i / 4][i % 4], 4 * column_shine + read_three) << i;
        EXPECT_EQ(record.layers[count / 4][static_cast<int>(count % 4)], -1) << "the background is the last";
    }
}

TEST(LayerRecord, RefusesMore)
{
    for (const std::size_t count : {std::size_t{most_layers}, std::size_t{most_layers + 5}}) {
        PictureRecord record{};
        EXPECT_THROW(list_layers(copies(count), record), Error) << count;
        EXPECT_EQ(record.samples.z, 0);
        EXPECT_EQ(record.layers[0], ivec4(0));
    }
}

TEST(LayerRecord, HoldsThoseOfEveryModel)
{
    for (const Model model : {Model::ggx, Model::phong}) {
        PictureRecord record{};
        EXPECT_NO_THROW(list_layers(layer_sources(model), record));
        EXPECT_EQ(static_cast<std::size_t>(record.samples.z), layer_sources(model).size() + 1);
    }
}

} // namespace
} // namespace lambent::draw
