// Reads bytes piece by piece from a file or from memory, so that decoders need not hold a large file in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace lambent::image {

/// A file or a block of memory of known size. May be used by one thread at a time.
class ByteSource {
public:
    virtual ~ByteSource() = default;

    /// The file's name, for messages.
    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }

    /// Copies `count` bytes from `offset` on to `out`. Throws Error(bad_input) if the source ends before them.
    void read(std::uint64_t offset, void* out, std::size_t count);

protected:
    ByteSource(std::string name, std::uint64_t size) : name_(std::move(name)), size_(size) {}

private:
    virtual void copy(std::uint64_t offset, void* out, std::size_t count) = 0;

    std::string name_;
    std::uint64_t size_;
};

/// Opens a regular file. Throws Error(bad_input) if it is missing, not regular or unreadable.
std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path);

/// Opens bytes in memory, which must outlive the source. `name` is used in messages.
std::unique_ptr<ByteSource> open_bytes(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace lambent::image
