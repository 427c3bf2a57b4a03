// A scene whose points and lines are replaced by triangles that face the camera.
#pragma once

#include "scene/scene.h"
#include "view/picture.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lambent::view {

/// The triangles made of points and lines depend on the camera and are visible to it only: they cast no shadows and
/// are not seen in reflections.
class WidenedScene {
public:
    /// Whether meshes without points and lines are kept.
    enum class Others { shown, left_out };

    /// Copies the scene without its images. Instances, materials and meshes keep their number and order, but meshes
    /// lose their points and lines: for these one mesh in world space follows per instance that shows some. `scene`
    /// must outlive this.
    WidenedScene(const scene::Scene& scene, Others others);

    /// Makes the triangles face the picture's camera. Returns whether that changes anything.
    bool face(const Picture& picture);

    /// The scene as of the last face(); before the first, without points and lines.
    const scene::Scene& scene() const { return widened_; }

private:
    /// The view that the triangles depend on.
    struct Sight {
        RayMap rays;
        int width = 0, height = 0;
        bool operator==(const Sight& other) const = default;
    };
    const scene::Scene& source_;
    scene::Scene widened_;
    std::vector<std::size_t> instances_; ///< that show points or lines
    std::optional<Sight> sight_;
};

} // namespace lambent::view
