// A scene whose points and lines are triangles, for pictures from one camera after the other.
#pragma once

#include "scene/scene.h"
#include "view/picture.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lambent::view {

/// What is made of a scene's points and lines is seen by the camera alone: it stands nowhere but in its picture, so it
/// casts no shadow and is in no mirror.
class WidenedScene {
public:
    /// Whether what the scene has besides points and lines is there, too.
    enum class Others { shown, left_out };

    /// Without images, else with instances and materials in the number and order of the scene's; so are its meshes, without
    /// their points and lines, which follow: a mesh in the world for each instance that shows some. `scene` must outlive it.
    WidenedScene(const scene::Scene& scene, Others others);

    /// Makes them face the picture's camera. Returns whether anything is changed by that.
    bool face(const Picture& picture);

    /// As of the last face(); before, without points and lines.
    const scene::Scene& scene() const { return widened_; }

private:
    /// What the shapes depend on.
    struct Sight {
        RayMap rays;
        int width = 0, height = 0;
        bool operator==(const Sight& other) const = default;
    };
    const scene::Scene& source_;
    scene::Scene widened_;
    std::vector<std::size_t> instances_; ///< that show them
    std::optional<Sight> sight_;
};

} // namespace lambent::view
