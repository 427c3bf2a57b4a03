// Texture coordinates by the number of their set.
#pragma once

#include <glm/vec2.hpp>

#include <map>
#include <vector>

namespace lambent::scene {

/// The sets of a mesh, TEXCOORD_n as number n. Numbers may be large and have gaps, so only existing sets are stored.
class TexcoordSets {
public:
    using Set = std::vector<glm::vec2>;

    Set& operator[](int number) { return sets_[number]; } ///< adds an empty set if there is none

    /// An empty set if there is none.
    const Set& operator[](int number) const
    {
        static const Set none;
        const auto found = sets_.find(number);
        return found == sets_.end() ? none : found->second;
    }

    /// Pairs of number and set, in the order of numbers.
    auto begin() { return sets_.begin(); }
    auto end() { return sets_.end(); }
    auto begin() const { return sets_.begin(); }
    auto end() const { return sets_.end(); }

private:
    std::map<int, Set> sets_;
};

} // namespace lambent::scene
