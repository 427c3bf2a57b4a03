// Coordinate systems in which the parts of the kitchen are built.
#pragma once

#include "kitchen/model/solids.h"
#include "kitchen/model/stuff.h"

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace lambent::kitchen {

/// The scene under construction.
struct Work {
    scene::Scene scene;
    std::uint32_t draws = 0; ///< random numbers drawn so far
};

/// A position in the kitchen with axes of its own, at which a part is built. Metres, +Y up.
class Site {
public:
    /// The axes of the room. `work` must outlive this and be empty.
    explicit Site(Work& work);

    /// A site at a position in this one's axes, turned by degrees about +Y, counter-clockwise seen from above.
    Site at(const glm::vec3& position, float degrees = 0.0f) const;

    /// This site turned further about +X, by degrees.
    Site tipped(float degrees) const;
    /// This site with its parts `scale` times as large.
    Site scaled(float scale) const;

    void add(Stuff stuff, const scene::Mesh& mesh, const glm::vec3& tint = glm::vec3(1.0f)) const;

    /// Texture coordinates get a random offset, so that no two boards look alike.
    void box(Stuff stuff, BoxShape shape, const glm::vec3& tint = glm::vec3(1.0f)) const;
    void lathe(Stuff stuff, const LatheShape& shape, const glm::vec3& tint = glm::vec3(1.0f)) const;
    void tube(Stuff stuff, const TubeShape& shape, const glm::vec3& tint = glm::vec3(1.0f)) const;

    /// The next number in [0, 1) of a sequence that is the same at every run.
    float chance() const;

private:
    Work* work_;
    glm::mat4 place_{1.0f};
};

} // namespace lambent::kitchen
