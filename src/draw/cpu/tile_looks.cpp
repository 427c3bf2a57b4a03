#include "draw/cpu/tile.h"

#include "draw/reach.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The visibility part of TileDrawer: looks, and the fragments made from them.

namespace lambent::draw {
namespace {

constexpr std::uint32_t no_surface = std::numeric_limits<std::uint32_t>::max();

} // namespace

// Traces a look through the centre of every pixel of the area and its border, in blocks of 4x4: a packet of rays.
void TileDrawer::look_at_centres(const TileArea& area)
{
    apron_x_ = std::max(area.x - 1, 0);
    apron_y_ = std::max(area.y - 1, 0);
    apron_width_ = std::min(area.x + area.width + 1, picture_.settings.width) - apron_x_;
    apron_height_ = std::min(area.y + area.height + 1, picture_.settings.height) - apron_y_;
    centres_.clear();
    for (int block_y = 0; block_y < apron_height_; block_y += 4)
        for (int block_x = 0; block_x < apron_width_; block_x += 4)
            for (int row = block_y; row < std::min(block_y + 4, apron_height_); ++row)
                for (int column = block_x; column < std::min(block_x + 4, apron_width_); ++column) {
                    Look look;
                    look.x = static_cast<float>(apron_x_ + column) + 0.5f;
                    look.y = static_cast<float>(apron_y_ + row) + 0.5f;
                    look.pixel = static_cast<std::uint32_t>(row * apron_width_ + column);
                    centres_.push_back(look);
                }
    sight_.look(centres_);
    seen_.resize(centres_.size());
    centre_.resize(centres_.size());
    const RayMap& rays = picture_.prepared.rays;
    for (const Look& look : centres_) {
        Seen& seen = seen_[look.pixel];
        centre_[look.pixel] = static_cast<std::uint32_t>(&look - centres_.data());
        seen.instance = look.hit.instance;
        if (!look.hit.found())
            continue;
        seen.normal = look.hit.normal;
        seen.point =
            rays.origin + look.x * rays.origin_dx + look.y * rays.origin_dy +
            look.hit.distance * (rays.direction + look.x * rays.direction_dx + look.y * rays.direction_dy);
        seen.pixel_width = glm::length(rays.origin_dx + look.hit.distance * rays.direction_dx);
    }
}

void TileDrawer::place_fragment(const Look& look, std::size_t at)
{
    fragments_[place_x][at] = look.x;
    fragments_[place_y][at] = look.y;
    fragments_[hit_distance][at] = look.hit.distance;
    fragments_[hit_u][at] = look.hit.u;
    fragments_[hit_v][at] = look.hit.v;
    fragments_[extent][at] = look.extent;
    fragments_.triangle[at] = look.hit.triangle;
    fragments_.pixel[at] = look.pixel;
    fragments_.weight[at] = look.weight;
}

// Turns looks into fragments, one per surface and pixel, in groups of one instance each.
void TileDrawer::build_fragments()
{
    surfaces_.clear();
    means_.clear();
    surface_of_.assign(looks_.size(), no_surface);
    std::size_t first_of_pixel = 0;
    for (std::size_t i = 0; i < looks_.size(); ++i) {
        const Look& look = looks_[i];
        if (!look.hit.found()) {
            background_[look.pixel] += look.weight;
            continue;
        }
        if (surfaces_.empty() || surfaces_.back().pixel != look.pixel)
            first_of_pixel = surfaces_.size();
        std::size_t at = first_of_pixel;
        while (at < surfaces_.size() && !share_shading(look.hit, surfaces_[at].hit))
            ++at;
        if (at == surfaces_.size() && look.weight <= 0.0f)
            continue;
        surface_of_[i] = static_cast<std::uint32_t>(at);
        if (at == surfaces_.size()) {
            surfaces_.push_back(look);
            means_.emplace_back(look.weight * look.x, look.weight * look.y);
        } else {
            surfaces_[at].weight += look.weight;
            surfaces_[at].extent = std::hypot(surfaces_[at].extent, look.extent);
            means_[at] += look.weight * glm::vec2(look.x, look.y);
        }
    }
    choose_places();
    place_fragments();
}

// A surface is shaded at the look nearest to the mean position of its looks.
void TileDrawer::choose_places()
{
    const auto distance = [&](const Look& look, std::size_t at) {
        return glm::length(glm::vec2(look.x, look.y) - means_[at] / surfaces_[at].weight);
    };
    for (std::size_t i = 0; i < looks_.size(); ++i) {
        const std::size_t at = surface_of_[i];
        if (at == no_surface || distance(looks_[i], at) >= distance(surfaces_[at], at))
            continue;
        const float weight = surfaces_[at].weight, side = surfaces_[at].extent;
        surfaces_[at] = looks_[i];
        surfaces_[at].weight = weight;
        surfaces_[at].extent = side;
    }
}

// Makes a group for the small and for the large surfaces of each visible instance, and stores the surfaces in their groups.
void TileDrawer::place_fragments()
{
    auto& groups = fragments_.groups;
    groups.clear();
    std::size_t last = 0;
    group_of_.clear();
    for (const Look& look : surfaces_) {
        // Neighbours mostly show the same instance, so the group of the last one is tried first.
        const auto holds = [&, small = look.weight < small_share](const Fragments::Group& group) {
            return group.instance == look.hit.instance && group.small == small;
        };
        if (groups.empty() || !holds(groups[last])) {
            const auto found = std::find_if(groups.begin(), groups.end(), holds);
            last = static_cast<std::size_t>(found - groups.begin());
            if (found == groups.end())
                groups.push_back({look.hit.instance, look.weight < small_share, 0, 0});
        }
        group_of_.push_back(static_cast<std::uint32_t>(last));
        ++groups[last].end;
    }
    std::size_t total = 0;
    for (Fragments::Group& group : groups) {
        const std::size_t filled = (group.end + Fragments::group_alignment - 1) / Fragments::group_alignment;
        group.begin = group.end = total;
        total += filled * Fragments::group_alignment;
    }
    fragments_.resize(total);
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        place_fragment(surfaces_[i], groups[group_of_[i]].end++);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        Look filler = surfaces_[i];
        filler.weight = 0.0f;
        for (std::size_t& end = groups[group_of_[i]].end; end % Fragments::group_alignment != 0; ++end)
            place_fragment(filler, end);
    }
}

// Traces the looks that continue behind transparent surfaces, with the remaining weight.
void TileDrawer::look_behind()
{
    looks_.clear();
    for (const Fragments::Group& group : fragments_.groups) {
        const scene::Material& material = *picture_.scene.surface(group.instance).material;
        if (material.alpha_mode == scene::AlphaMode::opaque)
            continue;
        for (std::size_t at = group.begin; at < group.end; ++at) {
            const float left =
                fragments_.weight[at] * (1.0f - shown(material, fragments_[column_opacity][at]));
            if (left < least_weight)
                continue;
            Look look;
            look.x = fragments_[place_x][at];
            look.y = fragments_[place_y][at];
            look.near = behind(fragments_[hit_distance][at]);
            look.pixel = fragments_.pixel[at];
            look.extent = fragments_[extent][at];
            look.weight = left;
            looks_.push_back(look);
        }
    }
    sight_.look(looks_);
}

} // namespace lambent::draw
