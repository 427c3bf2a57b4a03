#include "image/codes/png.h"

#include "image/codes/png_chunks.h"
#include "image/refuse.h"

#include <spng.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>

namespace lambent::image {
namespace {

// A small limit, because metadata (profiles, texts) is never used.
constexpr std::size_t max_metadata = std::size_t{16} << 20;

// A byte of a deflate stream decodes to at most 1032 bytes (zlib's "Technical Details" page).
constexpr std::uint64_t max_deflate_ratio = 1032;

struct Context {
    spng_ctx* spng;
    explicit Context(int flags) : spng(spng_ctx_new(flags))
    {
        if (!spng)
            throw std::bad_alloc();
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() { spng_ctx_free(spng); }
};

void check(int status, const std::string& name)
{
    if (status == SPNG_EMEM)
        throw std::bad_alloc();
    if (status != 0)
        refuse(name, "not a valid PNG: ", spng_strerror(status));
}

// A PNG in memory and the treatment of wrong checksums.
struct Source {
    std::span<const std::uint8_t> bytes;
    spng_crc_action wrong_checksum = SPNG_CRC_ERROR;
};

spng_ihdr open(const Context& png, const Source& source, const std::string& name)
{
    const std::span<const std::uint8_t> bytes = source.bytes;
    check(spng_set_crc_action(png.spng, source.wrong_checksum, source.wrong_checksum), name);
    check(spng_set_chunk_limits(png.spng, max_metadata, max_metadata), name);
    check(spng_set_png_buffer(png.spng, bytes.data(), bytes.size()), name);
    spng_ihdr header{};
    check(spng_get_ihdr(png.spng, &header), name);
    check_size(name, header.width, header.height);
    return header;
}

int stored_channels(const spng_ihdr& header)
{
    switch (header.color_type) {
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
        return 2;
    case SPNG_COLOR_TYPE_TRUECOLOR:
        return 3;
    case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
        return 4;
    default:
        return 1;
    }
}

void check_length(const spng_ihdr& header, std::size_t length, const std::string& name)
{
    const std::uint64_t bits = std::uint64_t{header.width} * header.height * header.bit_depth *
                               static_cast<std::uint64_t>(stored_channels(header));
    if (bits / 8 / max_deflate_ratio > length)
        refuse(name, "a file of ", length, " bytes cannot hold the ", header.width, "x", header.height,
               " pixels its header claims");
}

// Without interlacing, rows come in order, and memory grows with the rows that the file really has.
void decode_in_order(const Context& png, std::size_t row_bytes, CodeImage& image, const std::string& name)
{
    image.bytes.reserve(row_bytes * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        image.bytes.resize(image.bytes.size() + row_bytes);
        const int status =
            spng_decode_row(png.spng, image.bytes.data() + image.bytes.size() - row_bytes, row_bytes);
        if (status != SPNG_EOI)
            check(status, name);
    }
}

// Adam7 visits the rows in seven passes, so that memory for the whole image is needed from the start.
void decode_interlaced(const Context& png, std::size_t row_bytes, CodeImage& image, const std::string& name)
{
    image.bytes.resize(row_bytes * static_cast<std::size_t>(image.height));
    spng_row_info row{};
    while (spng_get_row_info(png.spng, &row) == 0) {
        const int status = spng_decode_row(png.spng, image.bytes.data() + row.row_num * row_bytes, row_bytes);
        if (status != SPNG_EOI)
            check(status, name);
    }
}

// Decodes all passes of a large interlaced file into a single row, so that a truncated file is refused before
// memory is allocated for the image.
void check_interlaced(const Source& source, const std::string& name)
{
    const Context png(0);
    const spng_ihdr header = open(png, source, name);
    check(spng_decode_image(png.spng, nullptr, 0, SPNG_FMT_RGBA8, SPNG_DECODE_PROGRESSIVE), name);
    std::vector<std::uint8_t> row(std::size_t{header.width} * 4);
    int status = 0;
    while (status == 0)
        status = spng_decode_scanline(png.spng, row.data(), row.size());
    if (status != SPNG_EOI)
        check(status, name);
}

std::string describe(const spng_ihdr& header)
{
    static constexpr std::array<const char*, 7> colours = {"grey",       "", "RGB", "palette",
                                                           "grey+alpha", "", "RGBA"};
    return text(int{header.bit_depth}, "-bit ", colours[header.color_type],
                header.interlace_method ? ", interlaced" : "");
}

CodeImage decode(const Source& source, const std::string& name)
{
    const Context png(0);
    const spng_ihdr header = open(png, source, name);
    check_length(header, source.bytes.size(), name);
    constexpr std::uint64_t large = std::uint64_t{1} << 22;
    if (header.interlace_method && std::uint64_t{header.width} * header.height > large)
        check_interlaced(source, name);

    CodeImage image{static_cast<int>(header.width),
                    static_cast<int>(header.height),
                    4,
                    header.bit_depth == 16 ? 16 : 8,
                    {}};
    const int format = image.bits == 16 ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    const std::size_t row_bytes = std::size_t{header.width} * (image.bits == 16 ? 8 : 4);
    check(spng_decode_image(png.spng, nullptr, 0, format, SPNG_DECODE_PROGRESSIVE | SPNG_DECODE_TRNS), name);
    if (header.interlace_method)
        decode_interlaced(png, row_bytes, image, name);
    else
        decode_in_order(png, row_bytes, image, name);
    check(spng_decode_chunks(png.spng), name);
    return image;
}

// They point into the notes.
std::vector<spng_text> texts_of(const Notes& notes)
{
    std::vector<spng_text> texts;
    for (const Note& note : notes) {
        spng_text text{};
        note.key.copy(text.keyword, sizeof text.keyword - 1);
        text.type = SPNG_TEXT;
        text.length = note.value.size();
        text.text = const_cast<char*>(note.value.c_str()); // only read by an encoder
        texts.push_back(text);
    }
    return texts;
}

} // namespace

bool is_png(std::span<const std::uint8_t> bytes)
{
    static constexpr std::array<std::uint8_t, 8> magic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

CodeImage decode_png(std::span<const std::uint8_t> bytes, const std::string& name, Warnings* warnings)
{
    try {
        return decode({bytes}, name);
    } catch (const Error& error) {
        if (warnings == nullptr)
            throw;
        const std::vector<std::uint8_t> needed = needed_chunks(bytes);
        CodeImage image;
        try {
            image = decode({needed, SPNG_CRC_USE}, name);
        } catch (const Error&) {
        }
        if (image.bytes.empty())
            throw;
        warnings->push_back(text(error.what(), ": its pixels are used nevertheless"));
        return image;
    }
}

ImageInfo inspect_png(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const Context png(0);
    const spng_ihdr header = open(png, {bytes}, name);
    return {"PNG", describe(header), static_cast<int>(header.width), static_cast<int>(header.height)};
}

std::vector<std::uint8_t> encode_png(const CodeImage& image, const PngEffort& effort, const Notes& notes)
{
    const Context png(SPNG_CTX_ENCODER);
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(image.width);
    header.height = static_cast<std::uint32_t>(image.height);
    header.bit_depth = static_cast<std::uint8_t>(image.bits);
    header.color_type = image.channels == 4 ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA : SPNG_COLOR_TYPE_TRUECOLOR;
    spng_set_option(png.spng, SPNG_ENCODE_TO_BUFFER, 1);
    spng_set_option(png.spng, SPNG_IMG_COMPRESSION_LEVEL, effort.level);
    spng_set_option(png.spng, SPNG_IMG_COMPRESSION_STRATEGY, effort.strategy);
    spng_set_option(png.spng, SPNG_FILTER_CHOICE, effort.filters);
    spng_set_ihdr(png.spng, &header);
    std::vector<spng_text> texts = texts_of(notes); // read while the image is encoded
    if (!texts.empty())
        spng_set_text(png.spng, texts.data(), static_cast<std::uint32_t>(texts.size()));
    std::size_t length = 0;
    int status = spng_encode_image(png.spng, image.bytes.data(), image.bytes.size(), SPNG_FMT_PNG,
                                   SPNG_ENCODE_FINALIZE);
    const std::unique_ptr<void, decltype(&std::free)> bytes(
        status == 0 ? spng_get_png_buffer(png.spng, &length, &status) : nullptr, &std::free);
    if (!bytes)
        throw std::bad_alloc();
    const auto* first = static_cast<const std::uint8_t*>(bytes.get());
    return {first, first + length};
}

} // namespace lambent::image
