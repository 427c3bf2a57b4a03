#include "tests/image/jpeg_files.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

namespace lambent::test {

const Bytes start_of_image = {0xff, 0xd8};
const Bytes end_of_image = {0xff, 0xd9};
const Bytes scan = {0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0b01000011};

Bytes table_segments()
{
    Bytes quantisation = {0xff, 0xdb, 0, 67, 0};
    quantisation.insert(quantisation.end(), 64, 8);
    Bytes dc = {0xff, 0xc4, 0, 20, 0x00, 1}, ac = {0xff, 0xc4, 0, 20, 0x10, 1};
    dc.insert(dc.end(), 15, 0);
    ac.insert(ac.end(), 15, 0);
    dc.push_back(4);
    ac.push_back(0);
    return quantisation + dc + ac;
}

Bytes frame(int width, int height, std::uint8_t process, std::uint8_t bits)
{
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value & 255); };
    return {0xff,        process, 0, 11,   bits, byte(height >> 8), byte(height), byte(width >> 8),
            byte(width), 1,       1, 0x11, 0};
}

Bytes tiny_jpeg()
{
    return start_of_image + table_segments() + frame(8, 8) + scan + end_of_image;
}

Bytes encode(int width, int height, const Encoding& encoding)
{
    const int channels = tjPixelSize[encoding.format];
    Bytes pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                pixels.push_back(static_cast<std::uint8_t>(40 + 2 * x + 3 * y + 20 * c));
    tjhandle handle = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long length = 0;
    EXPECT_EQ(tjCompress2(handle, pixels.data(), width, 0, height, encoding.format, &bytes, &length,
                          encoding.subsampling, 90, encoding.flags),
              0);
    Bytes result(bytes, bytes + length);
    tjFree(bytes);
    tjDestroy(handle);
    return result;
}

int slope(int x, int y, int channel)
{
    return channel == 0 ? 40 + 3 * x : channel == 1 ? 120 : 200 - 3 * y;
}

Bytes encode_sampled(int width, int height, const Sampling& sampling)
{
    jpeg_compress_struct compress{};
    jpeg_error_mgr errors{};
    compress.err = jpeg_std_error(&errors); // ends the program where something is wrong
    jpeg_create_compress(&compress);
    unsigned char* bytes = nullptr;
    unsigned long length = 0;
    jpeg_mem_dest(&compress, &bytes, &length);
    compress.image_width = static_cast<JDIMENSION>(width);
    compress.image_height = static_cast<JDIMENSION>(height);
    compress.input_components = 3;
    compress.in_color_space = JCS_RGB;
    jpeg_set_defaults(&compress);
    jpeg_set_quality(&compress, 95, TRUE);
    compress.comp_info[0].h_samp_factor = sampling.across;
    compress.comp_info[0].v_samp_factor = sampling.down;
    jpeg_start_compress(&compress, TRUE);
    Bytes row(static_cast<std::size_t>(width) * 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                row[static_cast<std::size_t>(3 * x + c)] = static_cast<std::uint8_t>(slope(x, y, c));
        JSAMPROW pointer = row.data();
        jpeg_write_scanlines(&compress, &pointer, 1);
    }
    jpeg_finish_compress(&compress);
    Bytes result(bytes, bytes + length);
    jpeg_destroy_compress(&compress);
    std::free(bytes);
    return result;
}

} // namespace lambent::test
