#include "scene/gltf/gltf_instancing.h"

#include "scene/gltf/gltf_accessor.h"
#include "scene/index.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <numeric>

namespace lambent::scene {
namespace {

constexpr const char* extension_name = "EXT_mesh_gpu_instancing";

class InstanceReader {
public:
    InstanceReader(const Document& document, int node, const gltf::AttributeMap& attributes)
        : document_(document), node_(node), attributes_(attributes)
    {
    }

    // The smallest and largest counts of all attributes, unknown ones included; nothing without attributes.
    struct Counts {
        std::size_t least = 0, most = 0;
    };
    std::optional<Counts> counts() const
    {
        std::optional<Counts> counts;
        for (const auto& [name, accessor] : attributes_) {
            const std::size_t count = accessor_count(document_, use(name));
            counts = counts ? Counts{std::min(counts->least, count), std::max(counts->most, count)}
                            : Counts{count, count};
        }
        return counts;
    }

    NodeInstances read(std::size_t count) const
    {
        std::vector<std::uint32_t> first(count);
        std::iota(first.begin(), first.end(), 0u);
        NodeInstances instances;
        instances.count = count;
        if (count == 0)
            return instances;
        if (attributes_.contains("TRANSLATION"))
            instances.translations = read_vec3(document_, use("TRANSLATION", first));
        if (attributes_.contains("ROTATION")) {
            AccessorUse rotations = use("ROTATION", first);
            rotations.normalized = true;
            instances.rotations = read_vec4(document_, rotations);
        }
        if (attributes_.contains("SCALE"))
            instances.scales = read_vec3(document_, use("SCALE", first));
        return instances;
    }

private:
    AccessorUse use(const std::string& name, std::span<const std::uint32_t> selection = {}) const
    {
        return {attributes_.at(name), text("node ", node_, ", ", extension_name, ", ", printable(name)),
                false, selection};
    }

    const Document& document_;
    int node_;
    const gltf::AttributeMap& attributes_;
};

} // namespace

glm::dmat4 NodeInstances::transform(std::size_t instance) const
{
    glm::dmat4 matrix(1.0);
    if (!translations.empty())
        matrix[3] = glm::dvec4(glm::dvec3(translations[instance]), 1.0);
    if (!rotations.empty()) {
        const glm::dvec4 q(rotations[instance]);
        matrix *= glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z) / glm::length(q));
    }
    return scales.empty() ? matrix : glm::scale(matrix, glm::dvec3(scales[instance]));
}

std::optional<NodeInstances> read_instances(const Document& document, int node, std::size_t most,
                                            Losses& losses)
{
    const InstanceReader reader(document, node, document.model.nodes[at(node)].instances);
    const auto warn = [&](const auto&... parts) {
        losses.add(text(document.file, ": node ", node, ", ", extension_name, ": ", parts...));
    };
    std::optional<NodeInstances> instances;
    losses.spare("the mesh is drawn once", [&] {
        const auto counts = reader.counts();
        if (!counts)
            return;
        if (counts->least != counts->most)
            warn("attributes of ", counts->least, " and of ", counts->most, " elements: ", counts->least,
                 " instances are drawn");
        if (counts->least > most)
            warn(counts->least, " instances: only ", most, " of them are drawn");
        instances = reader.read(std::min(counts->least, most));
    });
    return instances;
}

} // namespace lambent::scene
