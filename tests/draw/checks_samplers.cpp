// Texels by every sampler: the filters of Vulkan's chapter "Image Sampling", which are those of glTF, in double.
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lambent::draw::testing {
namespace {

using glm::dvec2, glm::dvec3;
using scene::Sampler, scene::Wrap;

// Texels of one mip map, as numbers from 0 to 1.
struct Level {
    int width = 0, height = 0;
    std::vector<dvec3> texels;
};

// Sizes that are neither equal nor powers of two. No two texels are alike.
Level pattern()
{
    Level level{12, 10, {}};
    for (int i = 0; i < level.width * level.height; ++i)
        level.texels.emplace_back((i * 67 % 256) / 255.0, (i * 149 % 256) / 255.0, (i * 41 % 256) / 255.0);
    return level;
}

image::CodeImage image_of(const Level& level)
{
    image::CodeImage image{level.width, level.height, 4, 8, {}};
    for (const dvec3& texel : level.texels) {
        for (int c = 0; c < 3; ++c)
            image.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * texel[c])));
        image.bytes.push_back(255);
    }
    return image;
}

// How much of texel i of n lies within part k of m equal parts of the row.
double overlap(int i, int n, int k, int m)
{
    const double low = std::max(i / static_cast<double>(n), k / static_cast<double>(m)),
                 high = std::min((i + 1) / static_cast<double>(n), (k + 1) / static_cast<double>(m));
    return std::max(high - low, 0.0);
}

// Every texel the mean of the area that it covers.
Level halved(const Level& from)
{
    Level to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            dvec3 sum(0.0);
            for (int v = 0; v < from.height; ++v)
                for (int u = 0; u < from.width; ++u)
                    sum += overlap(u, from.width, x, to.width) * overlap(v, from.height, y, to.height) *
                           from.texels[static_cast<std::size_t>(v * from.width + u)];
            to.texels.push_back(sum * static_cast<double>(to.width * to.height));
        }
    return to;
}

// [Vulkan 1.3, 16.6.8 "(s,t,r,q,a) to (u,v,w,a) Transformation", wrapping; glTF 2.0, 3.8.4.5]
int wrapped(int i, int size, Wrap wrap)
{
    if (wrap == Wrap::clamp_to_edge)
        return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size, within = ((i % period) + period) % period;
    return within < size ? within : period - 1 - within;
}

dvec3 texel(const Level& level, int x, int y, const Sampler& sampler)
{
    return level.texels[static_cast<std::size_t>(wrapped(y, level.height, sampler.wrap_v) * level.width +
                                                 wrapped(x, level.width, sampler.wrap_u))];
}

dvec3 filtered(const Level& level, dvec2 uv, bool nearest, const Sampler& sampler)
{
    const dvec2 place = uv * dvec2(level.width, level.height);
    if (nearest)
        return texel(level, static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y)),
                     sampler);
    const dvec2 corner = glm::floor(place - 0.5), share = place - 0.5 - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return glm::mix(glm::mix(texel(level, x, y, sampler), texel(level, x + 1, y, sampler), share.x),
                    glm::mix(texel(level, x, y + 1, sampler), texel(level, x + 1, y + 1, sampler), share.x),
                    share.y);
}

// A panel is `side` pixels wide and shows so many texels in each of them; the texture is turned and begins at `start`.
struct Panel {
    Sampler sampler;
    double texels = 1.0, turn = 0.0;
    dvec2 start{0.0};
};

constexpr int side = 20, gap = 4, columns = 12;

dvec2 coordinates(const Panel& panel, const dvec2& pixels)
{
    const double c = std::cos(panel.turn), s = std::sin(panel.turn);
    const dvec2 turned(c * pixels.x - s * pixels.y, s * pixels.x + c * pixels.y);
    return panel.start + panel.texels * turned / dvec2(12.0, 10.0);
}

dvec3 expected(const Panel& panel, const dvec2& pixels, const std::vector<Level>& levels)
{
    const Sampler& sampler = panel.sampler;
    const dvec2 uv = coordinates(panel, pixels);
    const double lambda = std::log2(panel.texels);
    if (lambda <= 0.0)
        return filtered(levels[0], uv, sampler.magnify_nearest, sampler);
    if (!sampler.mipmapped)
        return filtered(levels[0], uv, sampler.minify_nearest, sampler);
    const double d = std::min(lambda, static_cast<double>(levels.size() - 1));
    if (sampler.nearest_mipmap)
        return filtered(levels[static_cast<std::size_t>(std::ceil(d + 0.5)) - 1], uv, sampler.minify_nearest,
                        sampler);
    const auto fine = static_cast<std::size_t>(d), next = std::min(fine + 1, levels.size() - 1);
    return glm::mix(filtered(levels[fine], uv, sampler.minify_nearest, sampler),
                    filtered(levels[next], uv, sampler.minify_nearest, sampler),
                    d - static_cast<double>(fine));
}

std::vector<Panel> all_panels()
{
    std::vector<Panel> panels;
    const auto add_sizes = [&](const Sampler& sampler) {
        for (const double texels : {0.31, 1.43, 2.71, 5.9}) {
            const double more = 0.1 * static_cast<double>(panels.size());
            panels.push_back({sampler, texels, 0.4 + more, {-0.213 + 0.01 * more, 0.837 + 0.01 * more}});
        }
    };
    for (const Wrap u : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge})
        for (const Wrap v : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge})
            for (const bool magnify_nearest : {false, true})
                for (int filter = 0; filter < 6; ++filter) {
                    if (u != v && filter != 2 && filter != 4) // two of them do for mixed wraps
                        continue;
                    const bool mipmapped = filter < 4;
                    add_sizes(
                        {u, v, magnify_nearest, filter % 2 == 0, mipmapped && filter / 2 == 0, mipmapped});
                }
    return panels;
}

scene::TextureUse use_of(const Panel& panel)
{
    // From (0, 0) at the top left of a panel to (1, 1) at its other corner.
    const dvec2 origin = coordinates(panel, {0.0, 0.0}), right = coordinates(panel, {side, 0.0}) - origin,
                down = coordinates(panel, {0.0, side}) - origin;
    scene::TextureUse use;
    use.image = 0;
    use.sampler = panel.sampler;
    use.transform = glm::mat3(glm::vec3(right, 0.0), glm::vec3(down, 0.0), glm::vec3(origin, 1.0));
    return use;
}

} // namespace

void expect_samplers(const Draw& draw)
{
    std::vector<Level> levels = {pattern()};
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(halved(levels.back()));
    const std::vector<Panel> panels = all_panels();
    const int pitch = side + gap, rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    Settings settings =
        small_settings(columns * pitch, rows * pitch, front_camera(static_cast<float>(rows * pitch)));
    settings.texel_transfer = TexelTransfer::none;
    scene::Scene scene;
    scene.images.push_back(image_of(levels[0]));
    const auto corner = [&](std::size_t i) {
        return glm::ivec2(static_cast<int>(i) % columns, static_cast<int>(i) / columns) * pitch + gap / 2;
    };
    for (std::size_t i = 0; i < panels.size(); ++i) {
        scene::Material material;
        material.unlit = true;
        material.base_color_texture = use_of(panels[i]);
        const glm::vec2 middle =
            glm::vec2(corner(i)) + 0.5f * side - 0.5f * glm::vec2(settings.width, settings.height);
        add(scene, facing_square(0.5f * side, 0.0f), material,
            glm::translate(glm::mat4(1.0f), {middle.x, -middle.y, 0.0f}));
    }
    const Frame frame = draw(scene, nullptr, settings);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        int wrong = 0; // rounding may decide for another of two nearest texels
        double worst = 0.0;
        for (int y = 2; y < side - 2; ++y)
            for (int x = 2; x < side - 2; ++x) {
                const dvec3 seen(pixel(frame, corner(i).x + x, corner(i).y + y));
                const double off = glm::length(seen - expected(panels[i], {x + 0.5, y + 0.5}, levels));
                worst = std::max(worst, off);
                wrong += off > 0.008 ? 1 : 0; // mip maps are rounded to codes
            }
        const Sampler& s = panels[i].sampler;
        EXPECT_LE(wrong, 1) << "panel " << i << ": wraps " << static_cast<int>(s.wrap_u) << ' '
                            << static_cast<int>(s.wrap_v) << ", nearest " << s.magnify_nearest
                            << s.minify_nearest << s.nearest_mipmap << ", mip maps " << s.mipmapped << ", "
                            << panels[i].texels << " texels a pixel: " << worst;
    }
}

} // namespace lambent::draw::testing
