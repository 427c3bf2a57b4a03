#include "scene/gltf_mesh.h"

#include "scene/gltf_deform.h"
#include "scene/gltf_instancing.h"
#include "scene/gltf_mesh_table.h"
#include "scene/gltf_primitive.h"
#include "scene/index.h"
#include "scene/parallel.h"
#include "scene/transform.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lambent::scene {
namespace {

// Primitives may share accessors, and a small file may share a few of them a million times. Two million
// elements are free; beyond that a file may ask for so many for each byte of its buffers. Ordinary vertices
// with their indices take about 40 bytes and 6 elements: a hundred materials may be put on the same geometry.
constexpr std::uint64_t free_elements = 2'000'000;
constexpr std::uint64_t elements_per_byte = 16;
constexpr std::size_t most_instances = 1'000'000;
// Of nodes' own instances: each of them takes a few hundred bytes once it is drawn, and at least four in a file, but for
// accessors that are all zeros.
constexpr std::size_t free_node_instances = 100'000;
constexpr std::uint64_t bytes_per_node_instance = 4;
constexpr std::size_t most_node_instances = 4'000'000;

// What is read, and who shows it.
struct Plan {
    std::vector<PrimitiveRequest> requests;
    std::vector<int> materials; // of each request, as the file numbers them
    std::vector<bool> still;    // of each request, whether its shape is the same at every moment
    struct Use {
        int node;
        std::size_t request;
        int instance = -1; // of the node's own; -1: it has none
    };
    std::vector<Use> uses;
    std::map<int, NodeInstances> instances;      // by node
    std::vector<PrimitiveResult> results;        // of each request, once read
    std::map<int, std::vector<glm::mat4>> skins; // requests point into these
    std::size_t without_positions = 0;           // primitives left out
};

class Planner {
public:
    Planner(const Document& document, const NodeTree& nodes, Warnings& warnings)
        : document_(document), nodes_(nodes), warnings_(warnings)
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
        const tinygltf::Node& source = document_.model.nodes[at(node)];
        if (at(source.mesh) >= document_.model.meshes.size())
            document_.fail("node ", node, ": mesh ", source.mesh, " does not exist");
        const auto pose = nodes_.pose.find(node);
        const NodePose* morphing = pose != nodes_.pose.end() && pose->second.morphs ? &pose->second : nullptr;
        // Deformed by the node: no other node sees the same shape.
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

    // Whether the node says itself where its mesh is shown.
    bool add_instances(int node, const Range& range)
    {
        const std::size_t primitives = std::max<std::size_t>(range.end - range.begin, 1);
        const auto most = std::min<std::uint64_t>(
            most_node_instances, free_node_instances + document_.buffer_bytes() / bytes_per_node_instance);
        auto instances = read_instances(
            document_, node, (static_cast<std::size_t>(most) - instanced_) / primitives, warnings_);
        if (!instances)
            return false;
        instanced_ += instances->count * primitives;
        for (std::size_t i = 0; i < instances->count; ++i)
            for (std::size_t request = range.begin; request < range.end; ++request)
                plan_.uses.push_back({node, request, static_cast<int>(i)});
        plan_.instances.emplace(node, *std::move(instances));
        return true;
    }

    Range add_requests(const tinygltf::Node& node, const NodePose* morphing)
    {
        const tinygltf::Mesh& mesh = document_.model.meshes[at(node.mesh)];
        PrimitiveRequest request;
        request.mesh = node.mesh;
        request.weights = morphing ? morphing->weights : node.weights.empty() ? mesh.weights : node.weights;
        if (node.skin >= 0)
            request.skin = skin(node.skin);
        const std::size_t begin = plan_.requests.size();
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            request.primitive = static_cast<int>(i);
            if (!is_drawable(document_, request.mesh, request.primitive)) {
                ++plan_.without_positions;
                continue;
            }
            plan_.requests.push_back(request);
            plan_.materials.push_back(mesh.primitives[i].material);
            plan_.still.push_back(node.skin < 0 && morphing == nullptr);
        }
        return {begin, plan_.requests.size()};
    }

    const std::vector<glm::mat4>& skin(int index)
    {
        const auto found = plan_.skins.find(index);
        if (found != plan_.skins.end())
            return found->second;
        return plan_.skins.emplace(index, skin_matrices(document_, nodes_, index)).first->second;
    }

    const Document& document_;
    const NodeTree& nodes_;
    Warnings& warnings_;
    Plan plan_;
    std::size_t once_ = 0, instanced_ = 0; // uses by nodes, and by their own instances
    std::map<int, Range> shared_;          // by mesh
};

bool is_known(const ShapeStore& shapes, std::size_t request)
{
    return shapes.known != nullptr && (*shapes.known)[request].has_value();
}

// Before anything large is allocated.
void check_work(const Document& document, const Plan& plan, const ShapeStore& shapes)
{
    const std::uint64_t most = free_elements + elements_per_byte * document.buffer_bytes();
    std::uint64_t elements = 0;
    for (std::size_t i = 0; i < plan.requests.size(); ++i) {
        if (is_known(shapes, i))
            continue;
        elements += check_request(document, plan.requests[i]);
        if (elements > most)
            document.fail("its meshes read more than ", most, " elements out of ", document.buffer_bytes(),
                          " bytes");
    }
}

void warn(const Document& document, const PrimitiveNotes& notes, std::size_t without_positions,
          Warnings& warnings)
{
    const auto warn_if = [&](std::size_t count, const char* what) {
        if (count != 0)
            warnings.push_back(text(document.file, ": ", count, what));
    };
    warn_if(without_positions, " primitives without positions left out");
    warn_if(notes.left_over_indices, " indices after the last whole triangle or line left out");
    warn_if(notes.left_out_displacements, " morph targets of texture coordinates or colours left out");
    warn_if(notes.rebuilt_normals, " normals of no length rebuilt from the faces");
    warn_if(notes.rebuilt_tangents, " tangents of no use replaced");
    warn_if(notes.replaced_texcoords, " texture coordinates were not finite: replaced by 0");
    warn_if(notes.replaced_colors, " vertex colours were not finite: replaced by white");
    warn_if(notes.missing_texcoords,
            " primitives have textures but not the texture coordinates they are read at: (0, 0) is used");
}

// Squares of distances must fit a float with room to spare; nobody draws the Milky Way in metres.
bool is_within_reach(const glm::dmat4& transform, float reach)
{
    constexpr double farthest = 1e18;
    for (int axis = 0; axis < 3; ++axis) {
        double most = std::abs(transform[3][axis]);
        for (int column = 0; column < 3; ++column)
            most += std::abs(transform[column][axis]) * static_cast<double>(reach);
        if (!(most <= farthest))
            return false;
    }
    return true;
}

void read_results(const Document& document, const ShapeStore& shapes, Plan& plan)
{
    plan.results.resize(plan.requests.size());
    parallel_for_each_index(plan.results.size(), [&](std::size_t i) {
        plan.results[i] =
            is_known(shapes, i) ? *(*shapes.known)[i] : read_primitive(document, plan.requests[i]);
    });
    if (shapes.keep == nullptr)
        return;
    shapes.keep->assign(plan.results.size(), std::nullopt);
    for (std::size_t i = 0; i < plan.results.size(); ++i)
        if (plan.still[i])
            (*shapes.keep)[i] = plan.results[i];
}

// The instances that are out of sight show a mesh without triangles. Their material stays: whether anything is
// transparent should not depend on the moment.
void hide(const std::vector<std::size_t>& hidden, DrawnMeshes& drawn)
{
    const auto nothing = static_cast<int>(drawn.meshes.size());
    for (const std::size_t index : hidden) {
        Instance& instance = drawn.instances[index];
        instance = {nothing, drawn.meshes[at(instance.mesh)].material, glm::mat4(1.0f)};
    }
    drawn.meshes.emplace_back();
}

// World from mesh. A skinned mesh is in the world by its joints, whatever its node; its instances move it from there.
glm::dmat4 transform_of(const NodeTree& nodes, const Plan& plan, const Plan::Use& use)
{
    const glm::dmat4 node = plan.results[use.request].in_world ? glm::dmat4(1.0) : nodes.world[at(use.node)];
    return use.instance < 0 ? node : node * plan.instances.at(use.node).transform(at(use.instance));
}

// Whether an instance can be drawn. Throws Error(bad_input) for a node that is too far away.
bool is_drawn(const Document& document, const Plan& plan, const Plan::Use& use, const glm::dmat4& transform)
{
    if (!is_invertible(transform))
        return false;
    const bool near = is_within_reach(transform, plan.results[use.request].reach);
    if (!near && use.instance < 0)
        document.fail("node ", use.node, ": its vertices are more than 1e+18 m away");
    return near;
}

void assemble(const Document& document, const NodeTree& nodes, Plan& plan, DrawnMeshes& drawn,
              Warnings& warnings)
{
    MeshTable table(plan.results, plan.materials, drawn);
    const bool moves = !nodes.pose.empty();
    std::size_t singular = 0, useless = 0;
    std::vector<std::size_t> hidden;
    for (const Plan::Use& use : plan.uses) {
        const glm::dmat4 transform = transform_of(nodes, plan, use);
        const bool flat = !is_drawn(document, plan, use, transform);
        if (flat)
            ++(use.instance < 0 ? singular : useless);
        if (flat && !moves)
            continue;
        const int mesh = table.use(use.request);
        if (mesh < 0)
            continue;
        if (flat)
            hidden.push_back(drawn.instances.size());
        drawn.instances.push_back({mesh, -1, glm::mat4(transform)});
    }
    if (moves)
        hide(hidden, drawn);
    const auto warn_if = [&](std::size_t count, const auto&... what) {
        if (count != 0)
            warnings.push_back(text(document.file, ": ", count, what...));
    };
    warn_if(singular, " instances flattened by a singular transform: left out");
    warn_if(useless, " of the nodes' own instances are flat, not finite or out of reach: left out");
    warn_if(table.left_out(), " instances of points and lines, which are more than ", most_repeated_lines,
            " in all: left out");
}

} // namespace

DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, const ShapeStore& shapes,
                        Warnings& warnings)
{
    Plan plan = Planner(document, nodes, warnings).make();
    DrawnMeshes drawn;
    drawn.materials = read_materials(document, plan.materials, warnings);
    for (std::size_t i = 0; i < plan.requests.size(); ++i)
        plan.requests[i].needs =
            texture_needs(drawn.materials.materials[at(drawn.materials.index_of(plan.materials[i]))]);
    check_work(document, plan, shapes);
    read_results(document, shapes, plan);
    PrimitiveNotes notes;
    for (const PrimitiveResult& result : plan.results)
        notes += result.notes;
    warn(document, notes, plan.without_positions, warnings);
    assemble(document, nodes, plan, drawn, warnings);
    return drawn;
}

} // namespace lambent::scene
