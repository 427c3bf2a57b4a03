// All the light of a picture: shadows, and light from surface to surface, over the picture without them.
#pragma once

#include "draw/cpu/light_sums.h"
#include "draw/cpu/ray_gatherer.h"
#include "draw/cpu/tiles.h"
#include "draw/light/cache_rounds.h"
#include "draw/light/sample_plan.h"
#include "draw/frame.h"

#include <functional>
#include <memory>
#include <vector>

namespace lambent::draw {

/// Finds the light in stages, each over all tiles: places for the cache, which is filled with them; then passes of rays from
/// what the camera sees. May be stopped between tiles.
class FullLight {
public:
    /// `covered`: the area of the picture in which surfaces can be seen. `has_lights`: of the scene. `known`: a cache to take the light from, filled;
    /// null: it is filled first.
    FullLight(const Settings& settings, const view::PixelArea& covered, bool has_lights,
              std::shared_ptr<const WorldCache> known);

    /// The cache, once it is filled; null before, and where one bounce needs none.
    std::shared_ptr<const WorldCache> known() const { return known_; }

    /// Where the tiles of the picture without shadows leave what the later stages need.
    LightSums& sums() { return sums_; }

    /// Calls its second argument for every tile that is not done, in parallel, and marks it done; may leave some.
    using ForTiles = std::function<void(Tiles&, const std::function<void(int)>&)>;

    /// What a stage needs of its caller: the picture, a way to visit tiles, and what to call often where there are none; what
    /// it throws is passed on.
    struct Job {
        const PictureContext& picture;
        const ForTiles& for_tiles;
        const std::function<void()>& check;
        const Frame& frame; ///< without shadows, complete
    };
    /// Goes on from where it was stopped. Returns whether all rays have been traced.
    bool advance(const Job& job);

    /// Asks for more passes.
    void refine(int passes) { passes_ += passes; }

    /// Once all rays have been traced: filters what they found, and puts it in the place of the light without shadows in
    /// `frame` and in its layers. `check`, if set, is called often; what it throws is passed on.
    void apply(Frame& frame, const std::function<void()>& check) const;

    /// Calls of for_tiles' second argument for each tile, over all stages.
    int stages() const { return (asks_cache_ ? 1 : 0) + passes_; }

private:
    bool find_known(const Job& job);
    void plan_pass(const std::function<void()>& check);
    bool gather(const Job& job);
    RayGatherer::Places wanted_places() const;
    void apply(const denoise::FilteredRow& row, const std::vector<image::RadianceImage*>& images) const;

    const Settings& settings_;
    LightSums sums_;
    Tiles tiles_;
    bool asks_cache_;     ///< whether there is light that a cache has to know and none is given
    int passes_;          ///< asked for
    int pass_ = 0;        ///< the current one
    int planned_ = 0;     ///< the last one that was planned
    SamplePlan plan_;     ///< over the sums' area
    bool guided_ = false; ///< whether the sums of the picture without shadows are means
    std::vector<std::vector<PlaceSample>> places_; ///< by tile, until the cache is filled
    std::shared_ptr<const WorldCache> known_;
};

} // namespace lambent::draw
