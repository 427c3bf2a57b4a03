// All the light of a picture: shadows, and light from surface to surface, over the picture without them.
#pragma once

#include "draw/cpu/light_sums.h"
#include "draw/cpu/ray_gatherer.h"
#include "draw/cpu/tiles.h"
#include "draw/cpu/world_cache.h"
#include "draw/frame.h"

#include <functional>
#include <memory>

namespace lambent::draw {

/// Finds the light in stages, each over all tiles: rounds that fill the cache, each with the light that the one before
/// knew, so that each adds a bounce; then rays from what the camera sees; at last the filter. May be stopped between tiles.
class FullLight {
public:
    explicit FullLight(const Settings& settings);

    /// Where the tiles of the picture without shadows leave what the later stages need.
    LightSums& sums() { return sums_; }

    /// Calls its second argument for every tile that is not done, in parallel, and marks it done; may leave some.
    using ForTiles = std::function<void(Tiles&, const std::function<void(int)>&)>;

    /// Goes on from where it was stopped, over `frame`, the picture without shadows. Returns whether the picture is
    /// complete; it must then not be called again.
    bool advance(const PictureContext& picture, const ForTiles& for_tiles, Frame& frame);

    /// Calls of for_tiles' second argument for each tile, over all stages.
    int stages() const { return rounds_ + settings_.passes; }

private:
    bool fill_round(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame);
    bool fill_cache(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame);
    bool gather(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame);
    void finish(Frame& frame);
    int spacing(bool last) const;

    const Settings& settings_;
    LightSums sums_;
    Tiles tiles_;
    int rounds_;               ///< that fill the cache
    int round_ = 0, pass_ = 0; ///< the current ones
    WorldCache::Sizes sizes_;
    std::unique_ptr<WorldCache> known_, next_; ///< of the last round, and of this
};

} // namespace lambent::draw
