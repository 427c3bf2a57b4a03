#include "view/thin_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lambent::view {
namespace {

// Half the width of a shape, and the margin around the picture in which shapes are still drawn, in pixels.
constexpr double half_width = 0.5 + 1.0 / 256.0, clip_margin = 2.0;

double largest(const glm::dvec3& v)
{
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

// The nearest distance at which a pixel is at least two float steps wide: vertices are stored as floats.
double nearest_of(const glm::dvec3& origin, const glm::dvec3& dx, const glm::dvec3& dy)
{
    return 0x1p-22 * largest(origin) / std::min(glm::length(dx), glm::length(dy)) + 1e-30;
}

} // namespace

// A line in (t, x, y), and the part of it that is visible, from one vertex (0) to the other (1).
struct ThinShapes::Line {
    glm::uvec2 vertices;
    glm::dvec3 from, to;
    double first = 0.0, last = 1.0;

    glm::dvec3 at(double part) const { return from + part * (to - from); }
};

ThinShapes::ThinShapes(const RayMap& rays, int width, int height)
    : origin_(rays.origin),
      perspective_(rays.origin_dx == glm::vec3(0.0f) && rays.origin_dy == glm::vec3(0.0f))
{
    const glm::dvec3 direction(rays.direction), dx(perspective_ ? rays.direction_dx : rays.origin_dx),
        dy(perspective_ ? rays.direction_dy : rays.origin_dy);
    rays_ = glm::dmat3(direction, dx, dy);
    const double volume = std::fabs(glm::determinant(rays_)),
                 most = glm::length(direction) * glm::length(dx) * glm::length(dy);
    usable_ = volume > 1e-12 * most && std::isfinite(most) && std::isfinite(largest(origin_));
    if (!usable_)
        return;
    inverse_ = glm::inverse(rays_);
    const glm::dvec3 across = glm::normalize(glm::cross(dx, dy));
    facing_ = glm::dot(across, direction) < 0.0 ? across : -across;
    const glm::dvec4 one(0.0, 0.0, 0.0, 1.0), t(1.0, 0.0, 0.0, 0.0), x(0.0, 1.0, 0.0, 0.0),
        y(0.0, 0.0, 1.0, 0.0), w = perspective_ ? t : one;
    sides_ = {perspective_ ? t - nearest_of(origin_, dx, dy) * one : t, x + clip_margin * w,
              (width + clip_margin) * w - x, y + clip_margin * w, (height + clip_margin) * w - y};
}

// Clips a line to the view volume; false if none of it is left. [Liang and Barsky 1984, "A new concept and method for
// line clipping"]
bool ThinShapes::clip(Line& line) const
{
    for (const glm::dvec4& side : sides_) {
        const double from = glm::dot(side, glm::dvec4(line.from, 1.0)),
                     to = glm::dot(side, glm::dvec4(line.to, 1.0));
        if (!(from >= 0.0 || to >= 0.0))
            return false;
        if (from < 0.0)
            line.first = std::max(line.first, from / (from - to));
        else if (to < 0.0)
            line.last = std::min(line.last, from / (from - to));
    }
    return line.first <= line.last;
}

// Builds the triangles for the points and lines of one mesh.
class ThinShapes::Builder {
public:
    Builder(const ThinShapes& shapes, const scene::Mesh& mesh, const glm::mat4& transform)
        : shapes_(shapes), mesh_(mesh), transform_(transform),
          normals_(glm::transpose(glm::inverse(glm::dmat3(transform_)))),
          handedness_(glm::determinant(glm::dmat3(transform_)) < 0.0 ? -1.0f : 1.0f)
    {
        thin_.material = mesh.material;
    }

    void add_line(const glm::uvec2& vertices)
    {
        Line line{vertices, seen(vertices.x), seen(vertices.y)};
        if (!shapes_.clip(line))
            return;
        const glm::dvec2 way = place(line.at(line.last)) - place(line.at(line.first));
        const double length = glm::length(way);
        if (length > 1e-9)
            add_strip(line, half_width / length * glm::dvec2(-way.y, way.x));
    }

    void add_point(std::uint32_t vertex)
    {
        Line point{{vertex, vertex}, seen(vertex), {}};
        point.to = point.from;
        if (!shapes_.clip(point))
            return;
        const glm::dvec3 half(0.0, half_width * shapes_.share(point.from), 0.0);
        point.from -= half;
        point.to += half;
        add_strip(point, {0.0, half_width});
    }

    scene::Mesh take() { return std::move(thin_); }

private:
    glm::dvec3 seen(std::uint32_t vertex) const
    {
        return shapes_.seen(glm::dvec3(transform_ * glm::dvec4(mesh_.positions[vertex], 1.0)));
    }

    glm::dvec2 place(const glm::dvec3& seen) const
    {
        return glm::dvec2(seen.y, seen.z) / shapes_.share(seen);
    }

    // `aside`: half the width of the strip, in pixels: the line's direction in the picture turned by 90 degrees, from
    // right to down.
    void add_strip(const Line& line, const glm::dvec2& aside)
    {
        const auto first = static_cast<std::uint32_t>(thin_.positions.size());
        const float side = is_seen_from_behind(line) ? -1.0f : 1.0f;
        for (const double part : {line.first, line.last})
            for (const double sign : {-1.0, 1.0}) {
                const glm::dvec3 middle = line.at(part);
                const glm::dvec2 off = sign * shapes_.share(middle) * aside;
                thin_.positions.push_back(glm::vec3(shapes_.point(middle + glm::dvec3(0.0, off.x, off.y))));
                add_attributes(line.vertices, static_cast<float>(part), side);
            }
        // Counter-clockwise for the camera, since y points down.
        thin_.triangles.emplace_back(first, first + 1, first + 3);
        thin_.triangles.emplace_back(first, first + 3, first + 2);
        if (glm::determinant(shapes_.rays_) < 0.0) // the picture is mirrored
            for (auto triangle = thin_.triangles.end() - 2; triangle != thin_.triangles.end(); ++triangle)
                std::swap(triangle->y, triangle->z);
    }

    glm::dvec3 normal_of(std::uint32_t vertex) const
    {
        return glm::normalize(normals_ * glm::dvec3(mesh_.normals[vertex]));
    }

    bool is_seen_from_behind(const Line& line) const
    {
        if (mesh_.normals.empty())
            return false;
        const glm::dvec3 middle = line.at(0.5 * (line.first + line.last));
        const glm::dvec3 view = shapes_.perspective_ ? shapes_.rays_ * middle : shapes_.rays_[0];
        return glm::dot(normal_of(line.vertices.x) + normal_of(line.vertices.y), view) > 0.0;
    }

    void add_attributes(const glm::uvec2& vertices, float part, float side)
    {
        const auto between = [&](const auto& values) {
            return glm::mix(values[vertices.x], values[vertices.y], part);
        };
        if (mesh_.normals.empty()) {
            thin_.normals.emplace_back(shapes_.facing_);
        } else {
            const glm::dvec3 normal =
                glm::mix(normal_of(vertices.x), normal_of(vertices.y), static_cast<double>(part));
            thin_.normals.emplace_back(static_cast<double>(side) * normal);
        }
        if (!mesh_.tangents.empty()) {
            // Seen from behind, all axes of the tangent frame are reversed, and with them the mapped normal.
            const glm::vec4 tangent = side * between(mesh_.tangents);
            thin_.tangents.emplace_back(glm::dmat3(transform_) * glm::dvec3(tangent),
                                        handedness_ * side * mesh_.tangents[vertices.x].w);
        }
        for (const auto& [number, set] : mesh_.texcoords)
            if (!set.empty())
                thin_.texcoords[number].push_back(between(set));
        if (!mesh_.colors.empty())
            thin_.colors.push_back(between(mesh_.colors));
    }

    const ThinShapes& shapes_;
    const scene::Mesh& mesh_;
    const glm::dmat4 transform_;
    const glm::dmat3 normals_;
    const float handedness_;
    scene::Mesh thin_;
};

scene::Mesh ThinShapes::of(const scene::Mesh& mesh, const glm::mat4& transform) const
{
    Builder builder(*this, mesh, transform);
    if (usable_) {
        for (const glm::uvec2& line : mesh.lines)
            builder.add_line(line);
        for (const std::uint32_t point : mesh.points)
            builder.add_point(point);
    }
    return builder.take();
}

} // namespace lambent::view
