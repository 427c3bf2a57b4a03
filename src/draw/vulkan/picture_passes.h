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

/// The objects on a device that a picture is drawn with.
struct DeviceTools {
    const vulkan::Device& device;
    const vulkan::ShaderLayout& layout;
    const SceneOnDevice& scene;
    const TileOnDevice& tile;
    EnvironmentOnDevice& environment; ///< of the picture
    Passes& passes;
};

/// A rectangle of a picture, in pixels.
struct PictureArea {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The positions of the looks in a pixel: those for edges, if there are several, and then the centre.
std::vector<glm::vec2> look_places(const Edges& edges);

/// The name of a pass and its duration on the device in milliseconds.
using Lap = std::pair<std::string, double>;

/// Adds the duration to that of the same pass in the list; appends a pass that is new.
void add_lap(const Lap& lap, std::vector<Lap>& laps);

class PicturePasses {
public:
    /// The members of `tools`, and the picture, must outlive this. `bounds` are the scene's. Throws Error(no_device).
    PicturePasses(const DeviceTools& tools, const PreparedPicture& picture, const scene::Bounds& bounds);

    /// Draws the area, at most as large as the tile, into the frame. Throws Error(no_device).
    void draw(const PictureArea& area, Frame& frame);

    /// The durations of the passes, summed over all tiles so far.
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
