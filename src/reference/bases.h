// The bases of shading/passes/bases.h in double: reflection by the lowest lobe of a material, for each shading model.
#pragma once

#include "reference/facets.h"
#include "reference/point_material.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <variant>

namespace lambent::reference {

struct Surface;

/// Luminance that the two parts of a base reflect of white light from all directions, and the share of samples of each.
struct BaseParts {
    double glossy = 0.0;
    double diffuse = 0.0;
    double glossy_share = 1.0; ///< of draw()'s directions; the others are sampled by the cosine
};

/// The base of a surface by one model. Every specialisation has
///   value()    BRDF times the cosine, RGB per steradian; 0 below the surface
///   density()  density of draw() at a direction, per steradian
///   draw()     a sampled direction of incoming light, from two numbers in [0, 1); may be below the surface
///   albedo()   share of white light from everywhere that is reflected to the viewer, RGB
///   parts()    its BaseParts
///   alpha()    the roughness of its highlight
template <view::Model model>
class Base;

template <>
class Base<view::Model::ggx> {
public:
    Base(const Surface& surface, double compensation);
    glm::dvec3 value(const glm::dvec3& light) const { return facets_.value(light); }
    glm::dvec3 albedo() const { return facets_.share(); }
    double density(const glm::dvec3& light) const;
    glm::dvec3 draw(const glm::dvec2& u) const;
    const BaseParts& parts() const { return parts_; }
    double alpha() const { return facets_.alpha.x; }

private:
    Facets facets_;
    BaseParts parts_;
};

template <>
class Base<view::Model::phong> {
public:
    Base(const Surface& surface, double compensation);
    glm::dvec3 value(const glm::dvec3& light) const;
    glm::dvec3 albedo() const;
    double density(const glm::dvec3& light) const;
    glm::dvec3 draw(const glm::dvec2& u) const;
    const BaseParts& parts() const { return parts_; }
    double alpha() const;

private:
    double glossy_density(const glm::dvec3& light) const;
    glm::dvec3 draw_glossy(const glm::dvec2& u) const;

    glm::dvec3 normal_, view_;
    PointPhong phong_;
    BaseParts parts_;
};

/// variant<Ts...>. The unused first parameter allows lists whose rows all begin with a comma.
template <typename, typename... Ts>
using OneOf = std::variant<Ts...>;

/// The base by any of the models in the list.
using AnyBase = OneOf<void
#define BASE(name, number, layered) , Base<view::Model::name>
#include "shading/passes/bases.h"
                      >;

/// The base of a surface. `compensation`: for light scattered more than once, 0 or 1.
AnyBase base_of(const Surface& surface, view::Model model, double compensation);

/// Probability of sampling the first of two parts, from their luminances. At least 0.1 and at most 0.9, because a
/// colour may matter although its luminance is small.
double chance_of(double part, double rest);

/// Density of draw_cosine() at a direction, per steradian.
double cosine_density(const glm::dvec3& normal, const glm::dvec3& light);

/// Samples a direction above the surface in proportion to its cosine. [Malley; Pharr, Jakob and Humphreys 2016, 13.6.3]
glm::dvec3 draw_cosine(const glm::dvec3& normal, const glm::dvec2& u);

} // namespace lambent::reference
