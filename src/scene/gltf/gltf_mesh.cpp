#include "scene/gltf/gltf_mesh.h"

#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf/gltf_mesh_table.h"
#include "scene/gltf/gltf_plan.h"
#include "scene/gltf/gltf_primitive.h"
#include "scene/index.h"
#include "scene/parallel.h"
#include "scene/transform.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::scene {
namespace {

// Limit of the elements read: a constant, and a multiple of the bytes of all buffers. Primitives may share accessors,
// and a small file could share a few of them a million times. Ordinary vertices with their indices take about 40 bytes
// and 6 elements, so a hundred primitives may share the same geometry.
constexpr std::uint64_t free_elements = 2'000'000;
constexpr std::uint64_t elements_per_byte = 16;

using Results = std::vector<PrimitiveResult>; // one per request

bool is_known(const ShapeStore& shapes, std::size_t request)
{
    return shapes.known != nullptr && (*shapes.known)[request].has_value();
}

// Checks all requests before anything large is allocated. In the results, invalid requests are marked as lost.
Results check_work(const Document& document, const ShapeStore& shapes, const Plan& plan)
{
    Results results(plan.requests.size());
    const std::uint64_t most = free_elements + elements_per_byte * document.buffer_bytes();
    std::uint64_t elements = 0;
    for (std::size_t i = 0; i < plan.requests.size(); ++i) {
        if (is_known(shapes, i))
            continue;
        try {
            elements += check_request(document, plan.requests[i]);
        } catch (const Error& error) {
            results[i] = lost_primitive(error);
        }
        if (elements > most)
            document.fail("its meshes read more than ", most, " elements out of ", document.buffer_bytes(),
                          " bytes");
    }
    return results;
}

void read_results(const Document& document, const ShapeStore& shapes, const Plan& plan, Results& results)
{
    parallel_for_each_index(results.size(), [&](std::size_t i) {
        if (!results[i].is_lost)
            results[i] =
                is_known(shapes, i) ? *(*shapes.known)[i] : read_primitive(document, plan.requests[i]);
    });
    if (shapes.keep == nullptr)
        return;
    shapes.keep->assign(results.size(), std::nullopt);
    for (std::size_t i = 0; i < results.size(); ++i)
        if (plan.still[i])
            (*shapes.keep)[i] = results[i];
}

void warn(const Document& document, const PrimitiveNotes& notes, const Plan& plan, Warnings& warnings)
{
    const auto warn_if = [&](std::size_t count, const char* what) {
        if (count != 0)
            warnings.push_back(text(document.file, ": ", count, what));
    };
    warn_if(plan.without_positions, " primitives without positions left out");
    warn_if(notes.left_over_indices, " indices after the last whole triangle or line left out");
    warn_if(notes.left_out_displacements, " morph targets of texture coordinates or colours left out");
    warn_if(plan.odd_weights, " primitives have more or fewer morph targets than weights");
    warn_if(notes.restarts, " indices are the largest of their type, which restarts the primitive: triangles "
                            "and lines end there");
    warn_if(notes.broken_elements, " triangles, lines or points with positions that are not finite left out");
    warn_if(notes.rebuilt_normals, " normals without length rebuilt from the faces");
    warn_if(notes.rebuilt_tangents, " unusable tangents replaced");
    warn_if(notes.replaced_texcoords, " texture coordinates were not finite: replaced by 0");
    warn_if(notes.replaced_colors, " vertex colours were not finite: replaced by white");
    warn_if(notes.clamped_colors, " vertex colours outside of 0 to 1 clamped");
    warn_if(notes.missing_texcoords,
            " primitives have textures but not their texture coordinates: (0, 0) is used");
}

// Whether all coordinates are below 1e18 m, so that squared distances fit a float.
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

// Makes instances that cannot be drawn refer to an empty mesh. They keep their materials, so that whether a scene has
// transparent ones does not change from moment to moment.
void hide(const std::vector<std::size_t>& hidden, DrawnMeshes& drawn)
{
    const auto nothing = static_cast<int>(drawn.meshes.size());
    for (const std::size_t index : hidden) {
        Instance& instance = drawn.instances[index];
        instance = {nothing, drawn.meshes[at(instance.mesh)].material, glm::mat4(1.0f)};
    }
    drawn.meshes.emplace_back();
}

// Reports the faults of primitives, and throws if they leave nothing to draw.
void tell_losses(const std::string& lost_before, const Results& results, Losses& losses)
{
    std::string first = lost_before;
    bool draws = false;
    for (const PrimitiveResult& result : results) {
        for (const std::string& fault : result.faults)
            losses.add(fault);
        losses.add(result.loss, "the primitive is left out");
        first = first.empty() ? result.loss : first;
        draws = draws || !is_empty(result.mesh);
    }
    if (!draws && !first.empty())
        refuse(first);
}

// The first fault, before any primitive is read, that may have cost geometry.
std::string first_loss(const Document& document, const NodeTree& nodes, const Plan& plan)
{
    for (const std::string* loss : {&document.first_loss, &nodes.first_loss, &plan.first_loss})
        if (!loss->empty())
            return *loss;
    return {};
}

// World from mesh. Joints, not its node, place a skinned mesh in the world; its instances transform it from there,
// about the world's own origin.
glm::dmat4 transform_of(const NodeTree& nodes, const Plan& plan, const Plan::Use& use, bool in_world)
{
    const glm::dmat4 node = in_world ? glm::dmat4(1.0) : nodes.world[at(use.node)];
    if (use.instance < 0)
        return node;
    const glm::dmat4 instance = plan.instances.at(use.node).transform(at(use.instance));
    if (!in_world)
        return node * instance;
    return glm::translate(glm::dmat4(1.0), -nodes.origin) * instance *
           glm::translate(glm::dmat4(1.0), nodes.origin);
}

// Finds instances that cannot be drawn with their transforms, and reports them.
class UndrawableInstances {
public:
    UndrawableInstances(const Document& document, Warnings& warnings)
        : document_(document), warnings_(warnings), losses_(document.file, warnings)
    {
    }

    // Whether the instance cannot be drawn; if so, counts or reports it.
    bool add_if(const Plan::Use& use, const glm::dmat4& transform, float reach)
    {
        const bool flat = !is_invertible(transform);
        if (!flat && is_within_reach(transform, reach))
            return false;
        if (use.instance >= 0) {
            ++useless_;
        } else if (flat) {
            ++singular_;
        } else {
            far_ = text(document_.file, ": node ", use.node, ": its vertices are more than 1e+18 m away");
            losses_.add(far_, "left out");
        }
        return true;
    }

    // The last message about a node that is too far away; empty: none.
    const std::string& far() const { return far_; }

    void warn() const
    {
        const auto warn_if = [&](std::size_t count, const char* what) {
            if (count != 0)
                warnings_.push_back(text(document_.file, ": ", count, what));
        };
        warn_if(singular_, " instances flattened by a singular transform: left out");
        warn_if(useless_,
                " instances of EXT_mesh_gpu_instancing are flat, not finite or too far away: left out");
    }

private:
    const Document& document_;
    Warnings& warnings_;
    Losses losses_;
    std::size_t singular_ = 0, useless_ = 0;
    std::string far_;
};

// Adds the instances of results that are not empty, and the meshes of these, in order. Throws if everything is too far
// away.
void assemble(const Document& document, const NodeTree& nodes, const Plan& plan, MeshTable& table,
              Warnings& warnings)
{
    const bool moves = !nodes.pose.empty();
    DrawnMeshes& drawn = table.drawn();
    UndrawableInstances undrawable(document, warnings);
    std::vector<std::size_t> hidden;
    for (const Plan::Use& use : plan.uses) {
        const PrimitiveResult& result = table.result(use.request);
        const glm::dmat4 transform = transform_of(nodes, plan, use, result.in_world);
        const bool hides = undrawable.add_if(use, transform, result.reach);
        if (hides && !moves)
            continue;
        const int mesh = table.use(use.request);
        if (mesh < 0)
            continue;
        if (hides)
            hidden.push_back(drawn.instances.size());
        drawn.instances.push_back({mesh, -1, glm::mat4(transform)});
    }
    if (!undrawable.far().empty() && hidden.size() == drawn.instances.size())
        refuse(undrawable.far());
    if (moves)
        hide(hidden, drawn);
    undrawable.warn();
    if (table.left_out() != 0)
        warnings.push_back(text(document.file, ": ", table.left_out(),
                                " instances of points and lines beyond the limit of ", most_repeated_lines,
                                " left out"));
}

} // namespace

DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, const ShapeStore& shapes,
                        Warnings& warnings)
{
    Losses losses(document.file, warnings);
    Plan plan = make_plan(document, nodes, losses);
    DrawnMeshes drawn;
    drawn.materials = read_materials(document, plan.materials, warnings);
    for (std::size_t i = 0; i < plan.requests.size(); ++i)
        plan.requests[i].needs =
            texture_needs(drawn.materials.materials[at(drawn.materials.index_of(plan.materials[i]))]);
    Results results = check_work(document, shapes, plan);
    read_results(document, shapes, plan, results);
    tell_losses(first_loss(document, nodes, plan), results, losses);
    PrimitiveNotes notes;
    for (const PrimitiveResult& result : results)
        notes += result.notes;
    warn(document, notes, plan, warnings);
    MeshTable table(results, plan.materials, !nodes.pose.empty(), drawn);
    assemble(document, nodes, plan, table, warnings);
    return drawn;
}

} // namespace lambent::scene
