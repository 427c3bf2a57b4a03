#include "draw/cpu/tile.h"

#include "equations/in_double.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

// The part of TileDrawer that finds edges and chooses the looks of each pixel.

namespace lambent::draw {
namespace {

// Whether no edge lies between two points: their instance is the same, their normals are similar, and the second is
// less than a pixel's width from the tangent plane of the first.
bool same_surface(const Seen& a, const Seen& b, float least_cosine)
{
    if (a.instance != b.instance)
        return false;
    if (a.instance == Hit::nothing)
        return true;
    return glm::dot(a.normal, b.normal) > least_cosine &&
           std::fabs(glm::dot(b.point - a.point, a.normal)) < a.pixel_width;
}

// A look through a position in the pixel of another look.
Look look_in_pixel(Look look, const TileArea& area, const glm::vec2& place)
{
    const int pixel = static_cast<int>(look.pixel), column = pixel % area.width, row = pixel / area.width;
    look.x = static_cast<float>(area.x + column) + place.x;
    look.y = static_cast<float>(area.y + row) + place.y;
    look.near = 0.0f;
    return look;
}

} // namespace

PictureContext picture_context(const PreparedScene& scene, const Settings& settings,
                               const PreparedPicture& prepared)
{
    PictureContext picture{scene, settings, prepared, {}};
    for (std::size_t i = 0; i < scene.instance_count(); ++i) {
        const scene::Material& material = *scene.surface(static_cast<std::uint32_t>(i)).material;
        picture.all_opaque = picture.all_opaque && material.alpha_mode == scene::AlphaMode::opaque;
        picture.shared_cosines.push_back(static_cast<float>(in_double::shared_cosine(
            static_cast<double>(scene.typical_alpha(static_cast<std::uint32_t>(i)).in(settings)),
            static_cast<double>(prepared.edges.shared_cosine))));
    }
    return picture;
}

// Whether two looks of a pixel are shaded as one.
bool TileDrawer::share_shading(const Hit& a, const Hit& b) const
{
    if (a.instance != b.instance)
        return false;
    return !a.found() ||
           (a.front == b.front && glm::dot(a.normal, b.normal) > picture_.shared_cosines[a.instance]);
}

// Whether an edge lies between the centre of a pixel of the apron and that of a neighbour.
bool TileDrawer::is_edge(int column, int row) const
{
    const Seen* const middle = seen_.data() + row * apron_width_ + column;
    const int first = column > 0 ? -1 : 0, last = column < apron_width_ - 1 ? 1 : 0;
    for (int r = row > 0 ? -1 : 0; r <= (row < apron_height_ - 1 ? 1 : 0); ++r)
        for (int c = first; c <= last; ++c)
            if (!same_surface(*middle, middle[r * apron_width_ + c], picture_.prepared.edges.bend_cosine))
                return true;
    return false;
}

// Chooses the looks of every pixel: the one through its centre or, at an edge, several.
void TileDrawer::choose_looks(const TileArea& area)
{
    looks_.clear();
    middles_.clear();
    const bool several = picture_.prepared.edges.places.size() > 1;
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x) {
            const int column = area.x + x - apron_x_, row = area.y + y - apron_y_;
            Look look = centres_[centre_[static_cast<std::size_t>(row * apron_width_ + column)]];
            look.pixel = static_cast<std::uint32_t>(y * area.width + x);
            (several && is_edge(column, row) ? middles_ : looks_).push_back(look);
        }
    look_at_corners(area);
    look_at_edges(area);
}

// Pixels at edges whose four corners share the shading of their centre get the look through it; the others stay in
// middles_.
void TileDrawer::look_at_corners(const TileArea& area)
{
    const Edges& edges = picture_.prepared.edges;
    edges_.clear();
    for (const Look& middle : middles_)
        for (const int corner : edges.corners)
            edges_.push_back(look_in_pixel(middle, area, edges.places[static_cast<std::size_t>(corner)]));
    sight_.look(edges_);
    std::size_t left = 0;
    for (std::size_t i = 0; i < middles_.size(); ++i) {
        const std::span<const Look> corners(edges_.data() + edges.corners.size() * i, edges.corners.size());
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const Look& corner) { return share_shading(corner.hit, middles_[i].hit); }))
            looks_.push_back(middles_[i]);
        else
            middles_[left++] = middles_[i];
    }
    middles_.resize(left);
}

// Chooses all looks of the pixels of middles_.
void TileDrawer::look_at_edges(const TileArea& area)
{
    const Edges& edges = picture_.prepared.edges;
    edges_.clear();
    for (Look look : middles_) {
        look.weight = 1.0f / static_cast<float>(edges.places.size());
        look.extent = edges.extent;
        for (const glm::vec2& place : edges.places)
            edges_.push_back(look_in_pixel(look, area, place));
        // The central look covers nothing, but its surface may be shaded there.
        look.weight = look.extent = 0.0f;
        edges_.push_back(look_in_pixel(look, area, glm::vec2(0.5f)));
    }
    sight_.look(edges_);
    looks_.insert(looks_.end(), edges_.begin(), edges_.end());
}

} // namespace lambent::draw
