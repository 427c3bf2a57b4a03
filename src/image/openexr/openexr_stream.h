// The stream through which the OpenEXR library reads a file.
#pragma once

#include "image/byte_source.h"

#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lambent::image {

/// The file name that the library is given and uses in its messages.
inline constexpr char exr_stream_name[] = "it";

/// Reads a ByteSource, with the checked header instead of the file's own.
class ExrStream : public Imf::IStream {
public:
    ExrStream(ByteSource& source, std::vector<std::uint8_t> header)
        : Imf::IStream(exr_stream_name), source_(source), header_(std::move(header))
    {
    }

    // Returns whether bytes are left, as the library requires.
    bool read(char* out, int count) override
    {
        auto left = static_cast<std::size_t>(std::max(count, 0));
        if (at_ < header_.size()) {
            const std::size_t some = std::min(left, header_.size() - static_cast<std::size_t>(at_));
            std::memcpy(out, header_.data() + at_, some);
            at_ += some;
            out += some;
            left -= some;
        }
        source_.read(at_, out, left);
        at_ += left;
        return at_ < source_.size();
    }

    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

private:
    ByteSource& source_;
    std::vector<std::uint8_t> header_;
    std::uint64_t at_ = 0;
};

} // namespace lambent::image
