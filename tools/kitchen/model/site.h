// Where parts of the kitchen are put together.
#pragma once

#include "kitchen/model/solids.h"
#include "kitchen/model/stuff.h"

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace lambent::kitchen {

/// What is built.
struct Work {
    scene::Scene scene;
    std::uint32_t draws = 0; ///< how often chance has been asked
};

/// A place in the kitchen, with axes of its own, to build a part at. Metres, +Y up.
class Site {
public:
    /// The whole room. `work` must outlive this and be empty.
    explicit Site(Work& work);

    /// At a place of this one, turned by degrees about +Y, counter-clockwise seen from above.
    Site at(const glm::vec3& position, float degrees = 0.0f) const;

    /// After a further turn about +X, then everything is `scale` times as large.
    Site tipped(float degrees) const;
    Site scaled(float scale) const;

    void add(Stuff stuff, const scene::Mesh& mesh, const glm::vec3& tint = glm::vec3(1.0f)) const;

    /// Textures are moved by chance, so that no two boards look alike.
    void box(Stuff stuff, BoxShape shape, const glm::vec3& tint = glm::vec3(1.0f)) const;
    void lathe(Stuff stuff, const LatheShape& shape, const glm::vec3& tint = glm::vec3(1.0f)) const;
    void tube(Stuff stuff, const TubeShape& shape, const glm::vec3& tint = glm::vec3(1.0f)) const;

    /// In [0, 1), another one each time, the same in every kitchen.
    float chance() const;

private:
    Work* work_;
    glm::mat4 place_{1.0f};
};

} // namespace lambent::kitchen
