// Bytes read piece by piece, from a file or from memory, so that decoders never hold a large file whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// A file or a block of memory whose size is known. Not safe for use by several threads at once.
class ByteSource {
public:
    virtual ~ByteSource() = default;

    /// For messages.
    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }

    /// Copies `count` bytes from `offset` on to `out`. Throws Error(bad_input) when they are not all there.
    void read(std::uint64_t offset, void* out, std::size_t count);

protected:
    ByteSource(std::string name, std::uint64_t size) : name_(std::move(name)), size_(size) {}

private:
    virtual void copy(std::uint64_t offset, void* out, std::size_t count) = 0;

    std::string name_;
    std::uint64_t size_;
};

/// A regular file. Throws Error(bad_input) when it is missing, no regular file or unreadable.
std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path);

/// Memory, which must outlive the source.
std::unique_ptr<ByteSource> open_bytes(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace lambent::image
