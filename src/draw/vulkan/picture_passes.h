// All passes of a picture, tile by tile.
#pragma once

#include "draw/vulkan/background_on_device.h"
#include "draw/vulkan/passes.h"
#include "draw/vulkan/picture_on_device.h"
#include "draw/vulkan/scene_on_device.h"
#include "draw/vulkan/tile_on_device.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// What pictures are drawn with.
struct DeviceTools {
    const vulkan::Device& device;
    const vulkan::ShaderLayout& layout;
    const SceneOnDevice& scene;
    const TileOnDevice& tile;
    EnvironmentOnDevice& environment; ///< the picture's
    Passes& passes;
};

/// A part of a picture, pixels.
struct PictureArea {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The looks of a pixel: those of edges, if there are several, and the one through its middle.
std::vector<glm::vec2> look_places(const Edges& edges);

/// A pass and the milliseconds that it took on the device.
using Lap = std::pair<std::string, double>;

/// Adds it to its pass in the list; one that is new comes last.
void add_lap(const Lap& lap, std::vector<Lap>& laps);

class PicturePasses {
public:
    /// Everything must outlive it; `bounds`: of the scene. Throws Error(no_device).
    PicturePasses(const DeviceTools& tools, const PreparedPicture& picture, const scene::Bounds& bounds);

    /// Draws into the frame; the area is at most as large as the tile. Throws Error(no_device).
    void draw(const PictureArea& area, Frame& frame);

    /// Of all tiles so far.
    const std::vector<Lap>& times() const { return times_; }

private:
    vulkan::BindingSet bind() const;
    void describe(const PictureArea& area);
    bool draw_tile(const PictureArea& area);
    void draw_wave(int wave, vulkan::Commands& commands);
    void count_anew(vulkan::Commands& commands, int first) const;
    void find_fragments(int wave, vulkan::Commands& commands);
    void draw_triangles(int wave, vulkan::Commands& commands);
    void light(vulkan::Commands& commands);
    void finish(vulkan::Commands& commands);
    std::uint32_t counted(int counter) const;
    void run(vulkan::Commands& commands);
    void copy_to(const PictureArea& area, Frame& frame) const;

    const DeviceTools tools_;
    const PreparedPicture& prepared_;
    scene::Bounds bounds_;
    std::vector<glm::vec2> looks_;
    PictureOnDevice picture_;
    gpu_layout::PictureRecord record_;
    bool has_background_;
    vulkan::BindingSet set_;
    std::vector<Lap> times_;
};

} // namespace lambent::draw
