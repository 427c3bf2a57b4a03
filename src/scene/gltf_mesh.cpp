#include "scene/gltf_mesh.h"

#include "scene/gltf_deform.h"
#include "scene/gltf_losses.h"
#include "scene/gltf_primitive.h"
#include "scene/parallel.h"
#include "scene/transform.h"

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

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

// What is read, and who shows it.
struct Plan {
    std::vector<PrimitiveRequest> requests;
    std::vector<int> materials; // of each request, as the file numbers them
    std::vector<bool> still;    // of each request, whether its shape is the same at every moment
    struct Use {
        int node;
        std::size_t request;
    };
    std::vector<Use> uses;
    std::vector<PrimitiveResult> results;        // of each request, once read
    std::map<int, std::vector<glm::mat4>> skins; // requests point into these
    std::size_t not_triangles = 0;               // primitives left out
    std::size_t odd_weights = 0;                 // primitives with another number of targets than weights
    std::string first_loss;                      // the first fault that cost a primitive or mesh; empty: none
};

class Planner {
public:
    Planner(const Document& document, const NodeTree& nodes, Losses& losses)
        : document_(document), nodes_(nodes), losses_(losses)
    {
    }

    Plan make()
    {
        for (const int node : nodes_.drawn)
            if (document_.model.nodes[at(node)].mesh >= 0)
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
        if (at(source.mesh) >= document_.model.meshes.size()) {
            lose(text(document_.file, ": node ", node, ": mesh ", source.mesh, " does not exist"),
                 "left out");
            return;
        }
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
        if (plan_.uses.size() + (range.end - range.begin) > most_instances)
            document_.fail("more than ", most_instances, " instances");
        for (std::size_t request = range.begin; request < range.end; ++request)
            plan_.uses.push_back({node, request});
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
            if (is_broken(mesh.primitives[i].extensions) || !draws(request))
                continue;
            const std::size_t weights = request.weights.size();
            plan_.odd_weights += weights != 0 && weights != mesh.primitives[i].targets.size() ? 1 : 0;
            plan_.requests.push_back(request);
            plan_.materials.push_back(mesh.primitives[i].material);
            plan_.still.push_back(node.skin < 0 && morphing == nullptr);
        }
        return {begin, plan_.requests.size()};
    }

    // Counts what is not of triangles.
    bool draws(const PrimitiveRequest& request)
    {
        try {
            if (is_drawable(document_, request.mesh, request.primitive))
                return true;
            ++plan_.not_triangles;
        } catch (const Error& error) {
            lose(error.what(), "the primitive is left out");
        }
        return false;
    }

    // No matrices: it cannot be read, and what it moves is drawn without it.
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
    std::map<int, Range> shared_; // by mesh
};

bool is_known(const ShapeStore& shapes, std::size_t request)
{
    return shapes.known != nullptr && (*shapes.known)[request].has_value();
}

// Before anything large is allocated.
void check_work(const Document& document, const ShapeStore& shapes, Plan& plan)
{
    plan.results.resize(plan.requests.size());
    const std::uint64_t most = free_elements + elements_per_byte * document.buffer_bytes();
    std::uint64_t elements = 0;
    for (std::size_t i = 0; i < plan.requests.size(); ++i) {
        if (is_known(shapes, i))
            continue;
        try {
            elements += check_request(document, plan.requests[i]);
        } catch (const Error& error) {
            plan.results[i] = lost_primitive(error);
        }
        if (elements > most)
            document.fail("its meshes read more than ", most, " elements out of ", document.buffer_bytes(),
                          " bytes");
    }
}

void warn(const Document& document, const PrimitiveNotes& notes, const Plan& plan, Warnings& warnings)
{
    const auto warn_if = [&](std::size_t count, const char* what) {
        if (count != 0)
            warnings.push_back(text(document.file, ": ", count, what));
    };
    warn_if(plan.not_triangles, " primitives are points, lines or without positions: left out");
    warn_if(notes.left_over_indices, " indices after the last whole triangle left out");
    warn_if(notes.left_out_displacements, " morph targets of texture coordinates or colours left out");
    warn_if(plan.odd_weights, " primitives have another number of morph targets than of weights for them");
    warn_if(notes.restarts,
            " indices are the largest number of their type, which is no vertex: triangles end there");
    warn_if(notes.broken_triangles, " triangles with positions that are not finite left out");
    warn_if(notes.rebuilt_normals, " normals of no length rebuilt from the faces");
    warn_if(notes.rebuilt_tangents, " tangents of no use replaced");
    warn_if(notes.replaced_texcoords, " texture coordinates were not finite: replaced by 0");
    warn_if(notes.replaced_colors, " vertex colours were not finite: replaced by white");
    warn_if(notes.clamped_colors, " vertex colours outside of 0 to 1 clamped");
    warn_if(notes.missing_texcoords,
            " primitives have textures but not the texture coordinates they are read at: (0, 0) is used");
}

// Squares of distances must fit a float with room to spare; nobody draws the Milky Way in metres.
void check_reach(const Document& document, const glm::dmat4& transform, float reach, int node)
{
    constexpr double farthest = 1e18;
    for (int axis = 0; axis < 3; ++axis) {
        double most = std::abs(transform[3][axis]);
        for (int column = 0; column < 3; ++column)
            most += std::abs(transform[column][axis]) * static_cast<double>(reach);
        if (!(most <= farthest))
            document.fail("node ", node, ": its vertices are more than ", farthest, " m away");
    }
}

void read_results(const Document& document, const ShapeStore& shapes, Plan& plan)
{
    parallel_for_each_index(plan.results.size(), [&](std::size_t i) {
        if (!plan.results[i].is_lost)
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

// Tells what the primitives lost, and throws where that leaves nothing to draw.
void tell_losses(const Document& document, const NodeTree& nodes, const Plan& plan, Losses& losses)
{
    std::string first = document.first_loss;
    bool draws = false;
    for (const std::string& loss : {nodes.first_loss, plan.first_loss})
        first = first.empty() ? loss : first;
    for (const PrimitiveResult& result : plan.results) {
        for (const std::string& fault : result.faults)
            losses.add(fault);
        losses.add(result.loss, "the primitive is left out");
        first = first.empty() ? result.loss : first;
        draws = draws || !result.mesh.triangles.empty();
    }
    if (!draws && !first.empty())
        refuse(first);
}

// Instances of the results that have triangles; those results become meshes, in order. What was lost at this moment may
// be there at another: in a file that moves it is an empty mesh. Throws where all is too far away.
void assemble(const NodeTree& nodes, Plan& plan, DrawnMeshes& drawn, const Document& document,
              Warnings& warnings)
{
    Losses losses(document.file, warnings);
    std::string far;
    const auto is_far = [&](const glm::dmat4& transform, const PrimitiveResult& result, int node) {
        try {
            check_reach(document, transform, result.reach, node);
            return false;
        } catch (const Error& error) {
            losses.add(error.what(), "left out");
            far = error.what();
            return true;
        }
    };
    std::vector<int> mesh_of(plan.results.size(), -1);
    const bool moves = !nodes.pose.empty();
    std::size_t singular = 0;
    std::vector<std::size_t> hidden;
    for (const Plan::Use& use : plan.uses) {
        PrimitiveResult& result = plan.results[use.request];
        const glm::dmat4 transform = result.in_world ? glm::dmat4(1.0) : nodes.world[at(use.node)];
        const bool flat = !is_invertible(transform);
        singular += flat ? 1 : 0;
        const bool hides = flat || is_far(transform, result, use.node);
        if (hides && !moves)
            continue;
        if (mesh_of[use.request] < 0) {
            if (result.mesh.triangles.empty() && !(moves && result.is_lost))
                continue;
            mesh_of[use.request] = static_cast<int>(drawn.meshes.size());
            result.mesh.material = drawn.materials.index_of(plan.materials[use.request]);
            drawn.meshes.push_back(std::move(result.mesh));
        }
        if (hides)
            hidden.push_back(drawn.instances.size());
        drawn.instances.push_back({mesh_of[use.request], -1, glm::mat4(transform)});
    }
    if (!far.empty() && hidden.size() == drawn.instances.size())
        refuse(far);
    if (moves)
        hide(hidden, drawn);
    if (singular != 0)
        warnings.push_back(
            text(document.file, ": ", singular, " instances flattened by a singular transform: left out"));
}

} // namespace

DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, const ShapeStore& shapes,
                        Warnings& warnings)
{
    Losses losses(document.file, warnings);
    Plan plan = Planner(document, nodes, losses).make();
    check_work(document, shapes, plan);
    DrawnMeshes drawn;
    drawn.materials = read_materials(document, plan.materials, warnings);
    for (std::size_t i = 0; i < plan.requests.size(); ++i)
        plan.requests[i].needs =
            texture_needs(drawn.materials.materials[at(drawn.materials.index_of(plan.materials[i]))]);

    read_results(document, shapes, plan);
    tell_losses(document, nodes, plan, losses);
    PrimitiveNotes notes;
    for (const PrimitiveResult& result : plan.results)
        notes += result.notes;
    warn(document, notes, plan, warnings);
    assemble(nodes, plan, drawn, document, warnings);
    return drawn;
}

} // namespace lambent::scene
