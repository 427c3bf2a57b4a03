// What the OpenEXR library reads a file through.
#pragma once

#include "image/byte_source.h"

#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lambent::image {

/// The name by which the library calls what it reads.
inline constexpr char exr_nameless[] = "it";

/// A ByteSource, with the checked header in place of the one in the file.
class ExrStream : public Imf::IStream {
public:
    ExrStream(ByteSource& source, std::vector<std::uint8_t> header)
        : Imf::IStream(exr_nameless), source_(source), header_(std::move(header))
    {
    }

    // Returns whether more can be read, by the library's contract.
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
