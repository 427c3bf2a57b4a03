// The schema of materials: the rows of shading/material/, and the other properties that are read.
#include "scene/gltf_document/gltf_schema.h"

#include "scene/gltf_document/gltf_material_path.h"
#include "scene/gltf_document/gltf_model.h"

#include <algorithm>
#include <deque>
#include <vector>

namespace lambent::scene {
namespace {

// One number or several at a path in a material's JSON. (A texture's scale and strength are properties of the texture.)
struct FactorRow {
    std::string_view path;
    std::size_t components;
};

std::vector<FactorRow> factor_rows()
{
    std::vector<FactorRow> rows = {{"alphaCutoff", 1},
                                   {"extensions/KHR_materials_emissive_strength/emissiveStrength", 1}};
#define FACTOR(object, key, components)                                                                      \
    {                                                                                                        \
        static constexpr MaterialPath path(#object, #key);                                                   \
        rows.push_back({path.view(), components});                                                           \
    }
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) FACTOR(object, key, 4)
#define COLOR(name, number, value, object, key, texture) FACTOR(object, key, 3)
#define SCALAR(name, number, value, object, key, texture, channel) FACTOR(object, key, 1)
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) FACTOR(object, key, 1)
#define STRENGTH(name, factor, number, value, object, key, texture, channel) // a property of its texture
#include "shading/material/parameters.h"
#undef FACTOR
    return rows;
}

std::vector<std::string_view> texture_paths()
{
    std::vector<std::string_view> paths;
#define TEXTURE(name, number, transfer, object, key)                                                         \
    {                                                                                                        \
        static constexpr MaterialPath path(#object, #key);                                                   \
        paths.push_back(path.view());                                                                        \
    }
#define NORMAL_TEXTURE(name, number, object, key) TEXTURE(name, number, linear, object, key)
#include "shading/material/textures.h"
    return paths;
}

constexpr Property transform_properties[] = {
    value<&gltf::TextureTransform::offset>("offset"), value<&gltf::TextureTransform::rotation>("rotation"),
    value<&gltf::TextureTransform::scale>("scale"), value<&gltf::TextureTransform::tex_coord>("texCoord")};
constexpr Shape transform{transform_properties};
constexpr Property texture_extension_properties[] = {
    nested<&gltf::TextureInfo::transform>("KHR_texture_transform", transform)};
constexpr Shape texture_extensions{texture_extension_properties};
constexpr Property texture_info_properties[] = {
    value<&gltf::TextureInfo::index>("index", Need::required),
    value<&gltf::TextureInfo::tex_coord>("texCoord"), value<&gltf::TextureInfo::scale>("scale"),
    value<&gltf::TextureInfo::strength>("strength"), inside("extensions", texture_extensions)};
constexpr Shape texture_info{texture_info_properties};

gltf::Material& material_of(void* object)
{
    return *static_cast<gltf::Material*>(object);
}

Property factor(const FactorRow& row)
{
    Property property;
    property.kind = row.components == 1 ? Kind::number : Kind::numbers;
    property.length = row.components;
    property.key = row.path;
    property.place = [](void* object, const Property& self, std::size_t count) -> void* {
        std::vector<double>& numbers = material_of(object).factors[self.key];
        numbers.resize(count);
        return numbers.data();
    };
    return property;
}

Property texture_use(std::string_view path)
{
    Property property;
    property.kind = Kind::object;
    property.shape = &texture_info;
    property.key = path;
    property.place = [](void* object, const Property& self, std::size_t) -> void* {
        return &material_of(object).textures[self.key];
    };
    property.drop = [](void* object, const Property& self) { material_of(object).textures.erase(self.key); };
    return property;
}

// Makes the shapes of nested objects from the paths of their properties.
class PathShapes {
public:
    void add(std::string_view path, const Property& property) { rows_.push_back({path, property}); }

    // The shape of the object at a path, which ends with "/"; empty: of the outermost object.
    const Shape& shape(std::string_view below)
    {
        std::vector<Property> properties;
        for (const Row& row : rows_) {
            if (!row.path.starts_with(below))
                continue;
            const std::size_t slash = row.path.find('/', below.size());
            const std::string_view name = row.path.substr(below.size(), slash - below.size());
            const bool is_known = std::any_of(properties.begin(), properties.end(),
                                              [&](const Property& known) { return known.name == name; });
            if (slash == std::string_view::npos) {
                properties.push_back(row.property);
                properties.back().name = row.path.substr(below.size());
            } else if (!is_known) {
                properties.push_back(inside(name, shape(row.path.substr(0, slash + 1))));
            }
        }
        return shapes_.emplace_back(Shape{properties_.emplace_back(std::move(properties))});
    }

private:
    struct Row {
        std::string_view path;
        Property property;
    };

    std::vector<Row> rows_;
    std::deque<std::vector<Property>> properties_; // which the shapes refer to
    std::deque<Shape> shapes_;
};

} // namespace

const Shape& material_shape()
{
    static PathShapes paths;
    static const Shape& whole = [&]() -> const Shape& {
        paths.add("name", value<&gltf::Material::name>(""));
        paths.add("alphaMode", value<&gltf::Material::alpha_mode>(""));
        paths.add("doubleSided", value<&gltf::Material::double_sided>(""));
        paths.add("extensions/KHR_materials_unlit", presence<&gltf::Material::unlit>(""));
        for (const FactorRow& row : factor_rows())
            paths.add(row.path, factor(row));
        for (const std::string_view path : texture_paths())
            paths.add(path, texture_use(path));
        return paths.shape("");
    }();
    return whole;
}

} // namespace lambent::scene
