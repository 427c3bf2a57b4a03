#include "image/codes/jpeg_decoder.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jerror.h>
#include <jpeglib.h>

namespace lambent::image {
namespace {

constexpr JDIMENSION rows_at_a_time = 16;

} // namespace

// libjpeg is a C library: its errors leave by longjmp, which must not skip destructors. The functions between have no
// objects to destroy, and everything that they change is a member here.
struct JpegDecoder::State {
    jpeg_decompress_struct decompress{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf leave{};
    std::span<const std::uint8_t> bytes;
    int most_scans = 0;
    char error[JMSG_LENGTH_MAX] = {}, warning[JMSG_LENGTH_MAX] = {};
    bool ends_early = false, out_of_memory = false;

    static State& of(j_common_ptr info) { return *static_cast<State*>(info->client_data); }

    [[noreturn]] static void stop(j_common_ptr info)
    {
        State& state = of(info);
        state.out_of_memory = info->err->msg_code == JERR_OUT_OF_MEMORY;
        info->err->format_message(info, state.error);
        std::longjmp(state.leave, 1);
    }

    // Negative levels are warnings about damage, all others are trace messages.
    static void take_message(j_common_ptr info, int level)
    {
        if (level >= 0)
            return;
        State& state = of(info);
        if (info->err->num_warnings++ == 0)
            info->err->format_message(info, state.warning);
        state.ends_early = state.ends_early || info->err->msg_code == JWRN_JPEG_EOF;
    }

    static void count_scans(j_common_ptr info)
    {
        State& state = of(info);
        if (state.decompress.input_scan_number <= state.most_scans)
            return;
        std::snprintf(state.error, sizeof state.error, "more than %d scans", state.most_scans);
        std::longjmp(state.leave, 1);
    }

    void start(int divisor);
    void read(std::uint8_t* rgba);
};

void JpegDecoder::State::start(int divisor)
{
    jpeg_create_decompress(&decompress);
    progress.progress_monitor = &count_scans;
    decompress.progress = &progress;
    jpeg_mem_src(&decompress, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&decompress, TRUE);
    decompress.out_color_space = JCS_EXT_RGBA;
    decompress.dct_method = JDCT_ISLOW;
    decompress.scale_num = 1;
    decompress.scale_denom = static_cast<unsigned int>(divisor);
    jpeg_calc_output_dimensions(&decompress);
}

void JpegDecoder::State::read(std::uint8_t* rgba)
{
    jpeg_start_decompress(&decompress);
    const std::size_t row = std::size_t{decompress.output_width} * 4;
    while (decompress.output_scanline < decompress.output_height) {
        JSAMPROW rows[rows_at_a_time];
        const JDIMENSION count =
            std::min(rows_at_a_time, decompress.output_height - decompress.output_scanline);
        for (JDIMENSION i = 0; i < count; ++i)
            rows[i] = rgba + row * (decompress.output_scanline + i);
        jpeg_read_scanlines(&decompress, rows, count);
    }
    jpeg_finish_decompress(&decompress);
}

JpegDecoder::JpegDecoder(std::span<const std::uint8_t> bytes, int most_scans)
    : state_(std::make_unique<State>())
{
    state_->bytes = bytes;
    state_->most_scans = most_scans;
    state_->decompress.err = jpeg_std_error(&state_->errors);
    state_->errors.error_exit = &State::stop;
    state_->errors.emit_message = &State::take_message;
    state_->decompress.client_data = state_.get();
}

JpegDecoder::~JpegDecoder()
{
    jpeg_destroy_decompress(&state_->decompress);
}

bool JpegDecoder::open(int divisor)
{
    // NOLINTNEXTLINE(cert-err52-cpp): libjpeg reports errors by longjmp
    if (setjmp(state_->leave) != 0)
        return false;
    state_->start(divisor);
    return true;
}

bool JpegDecoder::read(std::uint8_t* rgba)
{
    // NOLINTNEXTLINE(cert-err52-cpp): libjpeg reports errors by longjmp
    if (setjmp(state_->leave) != 0)
        return false;
    state_->read(rgba);
    return true;
}

int JpegDecoder::width() const
{
    return static_cast<int>(state_->decompress.output_width);
}

int JpegDecoder::height() const
{
    return static_cast<int>(state_->decompress.output_height);
}

bool JpegDecoder::has_known_colours() const
{
    const J_COLOR_SPACE space = state_->decompress.jpeg_color_space;
    return space == JCS_GRAYSCALE || space == JCS_YCbCr || space == JCS_RGB;
}

JpegStatus JpegDecoder::status() const
{
    return {state_->error, state_->warning, state_->errors.num_warnings, state_->ends_early,
            state_->out_of_memory};
}

} // namespace lambent::image
