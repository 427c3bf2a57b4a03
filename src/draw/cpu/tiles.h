// The tiles of a picture, and which of them are done.
#pragma once

#include "draw/cpu/tile.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lambent::draw {

class Tiles {
public:
    Tiles(int width, int height)
        : width_(width), height_(height), columns_((width + size - 1) / size),
          done_(static_cast<std::size_t>(columns_ * ((height + size - 1) / size)), 0)
    {
    }

    int count() const { return static_cast<int>(done_.size()); }

    TileArea area(int tile) const
    {
        const int x = tile % columns_ * size, y = tile / columns_ * size;
        return {x, y, std::min(size, width_ - x), std::min(size, height_ - y)};
    }

    /// Each tile is accessed by one thread only.
    bool is_done(int tile) const { return done_[static_cast<std::size_t>(tile)] != 0; }
    void set_done(int tile) { done_[static_cast<std::size_t>(tile)] = 1; }

    int done_count() const { return static_cast<int>(std::count(done_.begin(), done_.end(), char(1))); }
    bool all_done() const { return done_count() == count(); }
    void restart() { std::fill(done_.begin(), done_.end(), char(0)); }

private:
    static constexpr int size = TileDrawer::largest_size;
    int width_, height_, columns_;
    std::vector<char> done_;
};

} // namespace lambent::draw
