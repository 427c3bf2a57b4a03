#include "scene/gltf/gltf_attributes.h"

#include <algorithm>
#include <set>

namespace lambent::scene {
namespace {

// The attribute's accessor. Throws if it has more or fewer elements than there are vertices.
std::optional<AccessorUse> vertex_attribute(const Document& document, const PrimitivePart& part,
                                            const std::string& name, std::size_t vertices)
{
    auto use = find_attribute(part, name);
    if (use && accessor_count(document, *use) != vertices)
        document.fail(use->what, " has ", accessor_count(document, *use), " elements, POSITION has ",
                      vertices);
    return use;
}

// The sets that the material needs, and the first two, which are always read.
std::set<int> texcoord_sets(const TextureNeeds& needs)
{
    std::set<int> sets = needs.texcoords;
    sets.insert({0, 1});
    return sets;
}

} // namespace

std::optional<AccessorUse> find_attribute(const PrimitivePart& part, const std::string& name)
{
    const auto found = part.primitive.attributes.find(name);
    if (found == part.primitive.attributes.end())
        return std::nullopt;
    return AccessorUse{found->second, part.name + ", " + name, false, part.selection};
}

void read_attributes(const Document& document, const PrimitivePart& part, const TextureNeeds& needs,
                     Losses& losses, Mesh& mesh)
{
    const AccessorUse positions = *find_attribute(part, "POSITION");
    const std::size_t vertices = accessor_count(document, positions);
    mesh.positions = read_vec3(document, positions);
    const auto read = [&](const std::string& name, auto&& into) {
        losses.spare("left out", [&] {
            if (auto use = vertex_attribute(document, part, name, vertices))
                into(*use);
        });
    };
    // Integers in unit vectors are fractions even if the file does not say so; lengths are corrected later.
    read("NORMAL", [&](AccessorUse& use) {
        use.normalized = true;
        mesh.normals = read_vec3(document, use);
    });
    if (!mesh.normals.empty())
        read("TANGENT", [&](AccessorUse& use) {
            use.normalized = true;
            mesh.tangents = read_vec4(document, use);
        });
    for (const int set : texcoord_sets(needs))
        read(text("TEXCOORD_", set),
             [&](const AccessorUse& use) { mesh.texcoords[set] = read_vec2(document, use); });
    read("COLOR_0", [&](AccessorUse& use) {
        use.normalized = true;
        mesh.colors = read_color(document, use);
    });
}

bool is_read(const std::string& attribute, const TextureNeeds& needs)
{
    if (attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" ||
        attribute == "COLOR_0" || attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_"))
        return true;
    const std::set<int> sets = texcoord_sets(needs);
    return std::any_of(sets.begin(), sets.end(),
                       [&](int set) { return attribute == text("TEXCOORD_", set); });
}

} // namespace lambent::scene
