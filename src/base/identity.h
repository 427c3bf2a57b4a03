// Which of all things of its kind one is.
#pragma once

#include <atomic>
#include <cstdint>

namespace lambent {

/// A member that says, by a number that none other ever had, that what was kept of a thing is still that of this thing:
/// addresses are used again. What is copied, moved from or assigned to is another thing from then on.
class Identity {
public:
    Identity() = default;
    Identity(const Identity&) {}
    Identity(Identity&& other) noexcept : number_(other.number_) { other.number_ = next(); }
    Identity& operator=(const Identity&)
    {
        number_ = next();
        return *this;
    }
    Identity& operator=(Identity&& other) noexcept
    {
        number_ = other.number_;
        other.number_ = next();
        return *this;
    }
    ~Identity() = default;

    /// Above 0.
    std::uint64_t number() const { return number_; }

private:
    static std::uint64_t next()
    {
        static std::atomic<std::uint64_t> last = 0;
        return ++last;
    }

    std::uint64_t number_ = next();
};

} // namespace lambent
