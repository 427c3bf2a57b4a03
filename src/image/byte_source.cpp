#include "image/byte_source.h"

#include "base/file.h"
#include "image/refuse.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace lambent::image {
namespace {

class FileSource : public ByteSource {
public:
    FileSource(const std::filesystem::path& path, std::uint64_t size, int descriptor)
        : ByteSource(path.string(), size), descriptor_(descriptor)
    {
    }
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    ~FileSource() override { ::close(descriptor_); }

private:
    void copy(std::uint64_t offset, void* out, std::size_t count) override
    {
        auto* to = static_cast<std::uint8_t*>(out);
        while (count > 0) {
            const ssize_t got = ::pread(descriptor_, to, count, static_cast<off_t>(offset));
            if (got < 0)
                refuse(name(), std::strerror(errno));
            if (got == 0)
                refuse(name(), "became shorter while it was read");
            to += got;
            offset += static_cast<std::uint64_t>(got);
            count -= static_cast<std::size_t>(got);
        }
    }

    int descriptor_;
};

class MemorySource : public ByteSource {
public:
    MemorySource(std::span<const std::uint8_t> bytes, const std::string& name)
        : ByteSource(name, bytes.size()), bytes_(bytes)
    {
    }

private:
    void copy(std::uint64_t offset, void* out, std::size_t count) override
    {
        std::memcpy(out, bytes_.data() + offset, count);
    }

    std::span<const std::uint8_t> bytes_;
};

} // namespace

void ByteSource::read(std::uint64_t offset, void* out, std::size_t count)
{
    if (offset > size_ || count > size_ - offset)
        refuse(name_, "ends after ", size_, " bytes, in the middle of its content");
    if (count > 0)
        copy(offset, out, count);
}

std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path)
{
    const std::uint64_t size = lambent::file_size(path);
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        refuse(path.string(), std::strerror(errno));
    return std::make_unique<FileSource>(path, size, descriptor);
}

std::unique_ptr<ByteSource> open_bytes(std::span<const std::uint8_t> bytes, const std::string& name)
{
    return std::make_unique<MemorySource>(bytes, name);
}

} // namespace lambent::image
