#include "base/file.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lambent {
namespace {

struct Descriptor {
    int fd = -1;
    explicit Descriptor(int fd) : fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (fd >= 0)
            ::close(fd);
    }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason)
{
    throw Error(Failure::bad_input, text(path.string(), ": ", reason));
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path)
{
    const int error = errno;
    throw Error(Failure::cannot_write, text(path.string(), ": cannot write: ", std::strerror(error)));
}

// Accepts regular files only: reading a pipe or a terminal could block forever, and a folder has no bytes.
std::uint64_t checked_size(int fd, const std::filesystem::path& path)
{
    struct stat status {};
    if (fd < 0 || ::fstat(fd, &status) != 0)
        fail_to_read(path, std::strerror(errno));
    if (S_ISDIR(status.st_mode))
        fail_to_read(path, "is a folder");
    if (!S_ISREG(status.st_mode))
        fail_to_read(path, "is not a regular file");
    return static_cast<std::uint64_t>(status.st_size);
}

void read_all(int fd, std::span<std::uint8_t> bytes, const std::filesystem::path& path)
{
    while (!bytes.empty()) {
        const ssize_t count = ::read(fd, bytes.data(), bytes.size());
        if (count < 0)
            fail_to_read(path, std::strerror(errno));
        if (count == 0)
            fail_to_read(path, "became shorter while it was read");
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

// A file in the same folder as the target, so that the rename cannot cross file systems. It is deleted unless it became
// the target.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target) : target_(target)
    {
        // The process id and a counter keep the names of processes and threads apart. A file that exists already was
        // left by a process that was killed, or belongs to another machine.
        static std::atomic<unsigned> counter{0};
        do {
            name_ = target;
            name_ += text(".", ::getpid(), ".", counter++, ".part");
            fd_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        } while (fd_ < 0 && errno == EEXIST);
        if (fd_ < 0)
            fail_to_write(target_);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (fd_ >= 0)
            ::close(fd_);
        if (!name_.empty())
            ::unlink(name_.c_str());
    }

    void write(std::span<const std::uint8_t> bytes)
    {
        while (!bytes.empty()) {
            const ssize_t count = ::write(fd_, bytes.data(), bytes.size());
            if (count < 0 && errno == EINTR)
                continue;
            if (count < 0)
                fail_to_write(target_);
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        }
    }

    // Some file systems report a full disk only on close().
    void become_target()
    {
        if (::close(std::exchange(fd_, -1)) != 0 || ::rename(name_.c_str(), target_.c_str()) != 0)
            fail_to_write(target_);
        name_.clear();
    }

private:
    const std::filesystem::path& target_;
    std::filesystem::path name_;
    int fd_ = -1;
};

} // namespace

std::uint64_t file_size(const std::filesystem::path& path)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    return checked_size(file.fd, path);
}

std::vector<std::uint8_t> read_start(const std::filesystem::path& path, std::size_t count)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    std::vector<std::uint8_t> bytes(std::min<std::uint64_t>(checked_size(file.fd, path), count));
    read_all(file.fd, bytes, path);
    return bytes;
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t limit)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    const std::uint64_t size = checked_size(file.fd, path);
    if (size > limit)
        fail_to_read(path, text(size, " bytes is more than the limit of ", limit));
    std::vector<std::uint8_t> bytes(size);
    read_all(file.fd, bytes, path);
    return bytes;
}

void check_can_write(const std::filesystem::path& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
        errno = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
        fail_to_write(path);
    }
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!path.has_filename() || ::access(folder.c_str(), W_OK | X_OK) != 0)
        fail_to_write(path);
}

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes)
{
    check_can_write(path);
    TemporaryFile file(path);
    file.write(bytes);
    file.become_target();
}

} // namespace lambent
