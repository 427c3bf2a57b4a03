// One tile of a picture, from camera rays to radiance: deferred passes over a G-buffer that fits in the cache.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/cpu/light_kernel.h"
#include "draw/cpu/light_sums.h"
#include "draw/cpu/sight.h"
#include "draw/prepared_picture.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace lambent::draw {

/// Data shared by all tiles of a picture.
struct PictureContext {
    const PreparedScene& scene;
    const Settings& settings;
    const PreparedPicture& prepared;
    std::vector<float> shared_cosines; ///< by instance: see Edges::shared_cosine
    bool all_opaque = true;            ///< whether no surface has an alpha mode

    /// An instance's surfaces, with the picture's settings.
    SurfaceContext surface(std::uint32_t instance) const;
};
PictureContext picture_context(const PreparedScene& scene, const Settings& settings,
                               const PreparedPicture& prepared);

struct TileArea {
    int x, y, width, height; ///< pixels
};

/// The surface at the centre of a pixel, for edge detection.
struct Seen {
    std::uint32_t instance = Hit::nothing;
    float pixel_width = 0.0f; ///< in world space, at `point`
    glm::vec3 point{0.0f}, normal{0.0f};
};

/// The opaque share of a surface, 0 to 1.
float shown(const scene::Material& material, float opacity);

/// Draws tiles one after the other; each thread has a drawer of its own.
class TileDrawer {
public:
    static constexpr int largest_size = 32; ///< pixels; the fragments then fit in the cache

    explicit TileDrawer(const PictureContext& picture);

    /// Draws the area, at most `largest_size` wide and high, into the frame. `sums`, if not null, gets the light without
    /// shadows in its classes, and what the filter is guided by.
    void draw(const TileArea& area, Frame& frame, LightSums* sums = nullptr);

private:
    void look_at_centres(const TileArea& area);
    bool is_edge(int column, int row) const;
    void choose_looks(const TileArea& area);
    void look_at_corners(const TileArea& area);
    void look_at_edges(const TileArea& area);
    bool share_shading(const Hit& a, const Hit& b) const;
    void build_fragments();
    void choose_places();
    void place_fragments();
    void place_fragment(const Look& look, std::size_t at);
    void shade();
    void find_group(const Fragments::Group& group);
    scene::Bounds bounds_of(const Fragments::Group& group) const;
    void light_group(const Fragments::Group& group);
    void darken(const Fragments::Group& group);
    void look_behind();
    void resolve(Frame& frame, const TileArea& area);
    void resolve_classes(LightSums& sums, const TileArea& area) const;
    void add_background(Frame& frame, const TileArea& area);

    const PictureContext& picture_;
    Sight sight_;
    Fragments fragments_;

    int apron_x_ = 0, apron_y_ = 0, apron_width_ = 0, apron_height_ = 0; ///< the area and one pixel around it
    std::vector<Look> centres_;             ///< of the apron's pixels, in the order of tracing
    std::vector<std::uint32_t> centre_;     ///< [row of the apron][column]: index into centres_
    std::vector<Seen> seen_;                ///< [row of the apron][column]
    std::vector<Look> looks_;               ///< of the current wave
    std::vector<Look> middles_;             ///< through the centres of pixels at edges
    std::vector<Look> edges_;               ///< of pixels at edges, several each
    std::vector<Look> surfaces_;            ///< looks that became fragments: one per surface and pixel
    std::vector<glm::vec2> means_;          ///< of each of surfaces_: weighted sum of its looks' positions
    std::vector<std::uint32_t> surface_of_; ///< of each of looks_: index into surfaces_
    std::vector<std::uint32_t> group_of_;   ///< of each of surfaces_: index into the groups
    std::vector<LightSource> lights_;       ///< that reach the current group
    std::vector<float> background_;         ///< per pixel of the tile: share not covered by surfaces
};

} // namespace lambent::draw
