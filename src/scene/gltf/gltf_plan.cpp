#include "scene/gltf/gltf_plan.h"

#include "scene/gltf/gltf_deform.h"
#include "scene/index.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace lambent::scene {
namespace {

// Limit of instances by nodes.
constexpr std::size_t most_instances = 1'000'000;
// Limits of nodes' own instances. Each takes a few hundred bytes once it is drawn, and at least four bytes of a file,
// except for accessors that are all zeros.
constexpr std::size_t free_node_instances = 100'000;
constexpr std::uint64_t bytes_per_node_instance = 4;
constexpr std::size_t most_node_instances = 4'000'000;

class Planner {
public:
    Planner(const Document& document, const NodeTree& nodes, Losses& losses)
        : document_(document), nodes_(nodes), losses_(losses)
    {
    }

    Plan make()
    {
        for (const int node : nodes_.drawn)
            if (document_.model.nodes[at(node)].mesh >= 0 && !nodes_.hidden[at(node)])
                add_node(node);
        return std::move(plan_);
    }

private:
    struct Range {
        std::size_t begin;
        std::size_t end;
    };

    void add_node(int node)
    {
        const gltf::Node& source = document_.model.nodes[at(node)];
        if (at(source.mesh) >= document_.model.meshes.size()) {
            lose(text(document_.file, ": node ", node, ": mesh ", source.mesh, " does not exist"),
                 "left out");
            return;
        }
        const auto pose = nodes_.pose.find(node);
        const NodePose* morphing = pose != nodes_.pose.end() && pose->second.morphs ? &pose->second : nullptr;
        // The node deforms the mesh, so other nodes cannot share its shape.
        const bool alone = source.skin >= 0 || !source.weights.empty() || morphing != nullptr;
        Range range;
        if (const auto shared = shared_.find(source.mesh); !alone && shared != shared_.end()) {
            range = shared->second;
        } else {
            range = add_requests(source, morphing);
            if (!alone)
                shared_[source.mesh] = range;
        }
        if (!add_instances(node, range))
            add_once(node, range);
    }

    void add_once(int node, const Range& range)
    {
        once_ += range.end - range.begin;
        if (once_ > most_instances)
            document_.fail("more than ", most_instances, " instances");
        for (std::size_t request = range.begin; request < range.end; ++request)
            plan_.uses.push_back({node, request});
    }

    // Adds the node's own instances. Returns whether it has any.
    bool add_instances(int node, const Range& range)
    {
        const std::size_t primitives = std::max<std::size_t>(range.end - range.begin, 1);
        const auto most = std::min<std::uint64_t>(
            most_node_instances, free_node_instances + document_.buffer_bytes() / bytes_per_node_instance);
        auto instances = read_instances(document_, node,
                                        (static_cast<std::size_t>(most) - instanced_) / primitives, losses_);
        if (!instances)
            return false;
        instanced_ += instances->count * primitives;
        for (std::size_t i = 0; i < instances->count; ++i)
            for (std::size_t request = range.begin; request < range.end; ++request)
                plan_.uses.push_back({node, request, static_cast<int>(i)});
        plan_.instances.emplace(node, *std::move(instances));
        return true;
    }

    Range add_requests(const gltf::Node& node, const NodePose* morphing)
    {
        const gltf::Mesh& mesh = document_.model.meshes[at(node.mesh)];
        PrimitiveRequest request;
        request.mesh = node.mesh;
        request.weights = morphing ? morphing->weights : node.weights.empty() ? mesh.weights : node.weights;
        if (node.skin >= 0)
            request.skin = skin(node.skin);
        const std::size_t begin = plan_.requests.size();
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            request.primitive = static_cast<int>(i);
            if (mesh.primitives[i].is_broken || !draws(request))
                continue;
            const std::size_t weights = request.weights.size();
            plan_.odd_weights += weights != 0 && weights != mesh.primitives[i].targets.size() ? 1 : 0;
            plan_.requests.push_back(request);
            plan_.materials.push_back(mesh.primitives[i].material);
            plan_.still.push_back(node.skin < 0 && morphing == nullptr);
        }
        return {begin, plan_.requests.size()};
    }

    // Whether the primitive can be drawn. Counts those without positions.
    bool draws(const PrimitiveRequest& request)
    {
        try {
            if (is_drawable(document_, request.mesh, request.primitive))
                return true;
            ++plan_.without_positions;
        } catch (const Error& error) {
            lose(error.what(), "the primitive is left out");
        }
        return false;
    }

    // The matrices of a skin; empty if it cannot be read: its meshes are drawn without it.
    const std::vector<glm::mat4>& skin(int index)
    {
        const auto [found, is_new] = plan_.skins.try_emplace(index);
        std::vector<glm::mat4>& matrices = found->second;
        if (is_new)
            losses_.spare("drawn without the skin",
                          [&] { matrices = skin_matrices(document_, nodes_, index); });
        return matrices;
    }

    void lose(const std::string& fault, const char* cost)
    {
        losses_.add(fault, cost);
        if (plan_.first_loss.empty())
            plan_.first_loss = fault;
    }

    const Document& document_;
    const NodeTree& nodes_;
    Losses& losses_;
    Plan plan_;
    std::size_t once_ = 0, instanced_ = 0; // uses by nodes, and by their own instances
    std::map<int, Range> shared_;          // by mesh
};

} // namespace

Plan make_plan(const Document& document, const NodeTree& nodes, Losses& losses)
{
    return Planner(document, nodes, losses).make();
}

} // namespace lambent::scene
