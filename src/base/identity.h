// A unique number per object, for caches to recognize it by.
#pragma once

#include <atomic>
#include <cstdint>

namespace lambent {

/// A member that identifies its object by a number that no other ever had, so that data cached for an object is not
/// taken for that of another one at the same address. Moving takes the number along; a copy, the target of a copy
/// assignment and a moved-from object get a new one.
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

    /// Greater than 0.
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
