// The lobes of shading/passes/bases.h in double: how the base of a material reflects, by each shading model.
#pragma once

#include "reference/facets.h"
#include "reference/point_material.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <variant>

namespace lambent::reference {

struct Surface;

/// What a base reflects, as luminance for white light from all around, and how often draw() takes which part.
struct BaseParts {
    double glossy = 0.0;
    double diffuse = 0.0;
    double glossy_share = 1.0; ///< of the draws; the rest is drawn by the cosine
};

/// The base of a surface by one model. Each has
///   value()    BRDF times the cosine, RGB per steradian; 0 below the surface
///   density()  of draw() at a direction, per steradian
///   draw()     a direction that light may come from, by two numbers in [0, 1); may be below the surface
///   parts()    BaseParts
///   alpha()    the roughness of its highlight
template <view::Model model>
class Base;

template <>
class Base<view::Model::ggx> {
public:
    Base(const Surface& surface, double compensation);
    glm::dvec3 value(const glm::dvec3& light) const { return facets_.value(light); }
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

/// variant<Ts...>; the first name is there for lists, whose rows begin with a comma.
template <typename, typename... Ts>
using OneOf = std::variant<Ts...>;

/// The base by one of the models of the list.
using AnyBase = OneOf<void
#define BASE(name, number, layered) , Base<view::Model::name>
#include "shading/passes/bases.h"
                      >;

/// The base of a surface, which has to outlive it. compensation: of light scattered more than once, 0 or 1.
AnyBase base_of(const Surface& surface, view::Model model, double compensation);

/// What is worth drawing by chance, of two parts: seldom what hardly shows, but never not at all, as colours differ from their
/// luminance.
double chance_of(double part, double rest);

/// Density of draw_cosine() at a direction, per steradian.
double cosine_density(const glm::dvec3& normal, const glm::dvec3& light);

/// A direction above the surface, in proportion to its cosine. [Malley; Pharr, Jakob and Humphreys 2016, 13.6.3]
glm::dvec3 draw_cosine(const glm::dvec3& normal, const glm::dvec2& u);

} // namespace lambent::reference
