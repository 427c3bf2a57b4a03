#include "bench/grid/grid_truth.h"

#include "albedo/albedo_table.h"
#include "equations/in_double.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace lambent::bench {
namespace {

using in_double::vec2;
using in_double::vec3;
using std::numbers::pi;

// As the renderer's.
constexpr double least_alpha = 1.0e-4, least_view_cosine = 1.0e-3;

vec3 to_vec(glm::vec3 v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

glm::dvec3 to_glm(vec3 v)
{
    return {v.x, v.y, v.z};
}

// Between the table's points, as the renderer reads it.
vec2 albedo_at(double NV, double alpha)
{
    constexpr int n = albedo_table_size;
    const double x = std::sqrt(std::clamp(NV, 0.0, 1.0)) * (n - 1), y = std::sqrt(alpha) * (n - 1);
    const int x0 = std::min(static_cast<int>(x), n - 2), y0 = std::min(static_cast<int>(y), n - 2);
    const auto at = [&](int i, int j) {
        const float* pair = albedo_table + 2 * ((y0 + j) * n + x0 + i);
        return vec2(static_cast<double>(pair[0]), static_cast<double>(pair[1]));
    };
    const double fx = x - x0, fy = y - y0;
    return (1 - fy) * ((1 - fx) * at(0, 0) + fx * at(1, 0)) + fy * ((1 - fx) * at(0, 1) + fx * at(1, 1));
}

// The panorama in floats, cut off at a limit, and what was cut off.
struct Light {
    int width = 0, height = 0;
    std::vector<float> rgb;
    struct Peak {
        vec3 light; // radiance times solid angle
        vec3 direction;
    };
    struct Cut {
        int x, y;
        vec3 excess;
    };
    std::vector<Cut> cuts;

    vec3 texel(int x, int y) const
    {
        const float* p = rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x));
        return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    }

    vec3 row(int left, int right, int y, double fraction) const
    {
        if (y < 0 || y >= height) { // across the pole
            y = std::clamp(y, 0, height - 1);
            left = (left + width / 2) % width, right = (right + width / 2) % width;
        }
        return mix(texel(left, y), texel(right, y), fraction);
    }

    vec3 bilinear(vec3 d) const
    {
        const vec2 uv = in_double::equirectangular_from_direction(d);
        const double x = uv.x * width - 0.5, y = uv.y * height - 0.5;
        const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
        const int left = (x0 + width) % width, right = (x0 + 1) % width;
        return mix(row(left, right, y0, x - x0), row(left, right, y0 + 1, x - x0), y - y0);
    }
};

Light light_of(const environment::Panorama& panorama, bool cut)
{
    constexpr std::size_t most_cuts = 1500;
    Light light;
    light.width = panorama.width, light.height = panorama.height;
    std::vector<float> largest;
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const environment::Rgb c = panorama.radiance(x, y);
            light.rgb.insert(light.rgb.end(), {c.r, c.g, c.b});
            largest.push_back(std::max(c.r, std::max(c.g, c.b)));
        }
    if (!cut)
        return light;
    std::vector<float> sorted = largest;
    double mean = 0.0;
    for (float value : sorted)
        mean += static_cast<double>(value) / static_cast<double>(sorted.size());
    const std::size_t index = sorted.size() - std::min(sorted.size(), most_cuts);
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(index), sorted.end());
    const double limit = std::max(10.0 * mean, static_cast<double>(sorted[index]));
    for (std::size_t i = 0; i < largest.size(); ++i) {
        if (static_cast<double>(largest[i]) <= limit)
            continue;
        const int x = static_cast<int>(i) % light.width, y = static_cast<int>(i) / light.width;
        const double kept = limit / static_cast<double>(largest[i]);
        light.cuts.push_back({x, y, (1.0 - kept) * light.texel(x, y)});
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            light.rgb[k] *= static_cast<float>(kept);
    }
    return light;
}

// Each cut texel's bilinear hat as points x points lights.
std::vector<Light::Peak> peaks_of(const Light& light, int points)
{
    std::vector<Light::Peak> peaks;
    const double texel = 2.0 * pi / light.width * pi / light.height;
    for (const Light::Cut& cut : light.cuts)
        for (int j = 0; j < points; ++j)
            for (int i = 0; i < points; ++i) {
                const double dx = (i + 0.5) / points * 2.0 - 1.0, dy = (j + 0.5) / points * 2.0 - 1.0;
                const vec2 uv((cut.x + 0.5 + dx) / light.width, (cut.y + 0.5 + dy) / light.height);
                const double weight = (1.0 - std::abs(dx)) * (1.0 - std::abs(dy)) * 4.0 / (points * points);
                peaks.push_back({(weight * texel * std::sin(uv.y * pi)) * cut.excess,
                                 in_double::direction_from_equirectangular(uv)});
            }
    return peaks;
}

// What a ray of sight meets.
struct Met {
    vec3 normal, view;
};

// The triangles of the one mesh, at one sphere's place, that may be met in one pixel.
class SphereRays {
public:
    SphereRays(const scene::Scene& scene, int sphere, const draw::RayMap& rays)
        : mesh_(scene.meshes[0]), rays_(rays),
          offset_(to_vec(glm::vec3(scene.instances[static_cast<std::size_t>(sphere)].transform[3])))
    {
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
            near_.push_back(i);
    }

    // Remembers which triangles are met from pixel (x, y); false when some of it sees beside the sphere.
    bool enter_pixel(int x, int y)
    {
        std::vector<std::size_t> met;
        constexpr int across = 8;
        for (int i = 0; i <= across; ++i)
            for (int j = 0; j <= across; ++j) {
                const auto hit =
                    meet(x + static_cast<double>(i) / across, y + static_cast<double>(j) / across);
                if (!hit)
                    return false;
                met.push_back(last_);
            }
        std::sort(met.begin(), met.end());
        met.erase(std::unique(met.begin(), met.end()), met.end());
        all_ = near_;
        near_ = met;
        return true;
    }

    void leave_pixel() { near_ = all_; }

    std::optional<Met> meet(double x, double y)
    {
        const vec3 origin =
            to_vec(rays_.origin) + x * to_vec(rays_.origin_dx) + y * to_vec(rays_.origin_dy) - offset_;
        const vec3 direction =
            to_vec(rays_.direction) + x * to_vec(rays_.direction_dx) + y * to_vec(rays_.direction_dy);
        double nearest = 1e30;
        vec3 normal(0.0);
        for (std::size_t index : near_) {
            const auto& t = mesh_.triangles[index];
            const vec3 a = corner(mesh_.positions, t[0]);
            const vec3 e1 = corner(mesh_.positions, t[1]) - a, e2 = corner(mesh_.positions, t[2]) - a;
            const vec3 p = cross(direction, e2), s = origin - a;
            const double determinant = dot(e1, p);
            if (std::abs(determinant) < 1e-300)
                continue;
            const double u = dot(s, p) / determinant;
            const vec3 q = cross(s, e1);
            const double v = dot(direction, q) / determinant, distance = dot(e2, q) / determinant;
            if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9 || distance <= 0 || distance >= nearest)
                continue;
            nearest = distance;
            last_ = index;
            normal = (1.0 - u - v) * corner(mesh_.normals, t[0]) + u * corner(mesh_.normals, t[1]) +
                     v * corner(mesh_.normals, t[2]);
        }
        if (nearest > 1e29)
            return std::nullopt;
        const vec3 view = -normalize(direction);
        return Met{in_double::facing_normal(normalize(normal), view, least_view_cosine), view};
    }

private:
    template <class Index>
    static vec3 corner(const std::vector<glm::vec3>& values, Index i)
    {
        return to_vec(values[static_cast<std::size_t>(i)]);
    }

    const scene::Mesh& mesh_;
    draw::RayMap rays_;
    vec3 offset_;
    std::vector<std::size_t> near_, all_;
    std::size_t last_ = 0;
};

double fraction(double x)
{
    return x - std::floor(x);
}

// Points of the unit square by the powers of the plastic number. [Roberts 2018]
vec2 spread_point(std::uint64_t i)
{
    constexpr double plastic = 1.32471795724474602596;
    return {fraction(0.5 + static_cast<double>(i) / plastic),
            fraction(0.5 + static_cast<double>(i) / (plastic * plastic))};
}

in_double::Metallic metallic_of(const scene::Material& m)
{
    const double r = static_cast<double>(m.perceptual_roughness);
    return {to_vec(glm::vec3(m.base_color)), static_cast<double>(m.metallic),
            vec2(std::max(r * r, least_alpha)), vec3(0.0), 1.0};
}

// What brdf_metallic multiplies its lobe by, as factors of Schlick's two parts.
struct Gains {
    vec3 plain, grazing;
};

Gains gains_of(const in_double::Metallic& m, vec2 albedo)
{
    const double F0 = in_double::dielectric_reflectance();
    const vec3 d = (1.0 - m.metalness) * in_double::energy_compensation(vec3(F0), albedo, m.compensation);
    const vec3 metal = m.metalness * in_double::energy_compensation(m.base, albedo, m.compensation);
    return {F0 * d + m.base * metal, d + metal};
}

vec3 reflectance(const Gains& gains, double VH)
{
    const double grazing = in_double::schlick_weight(VH);
    return (1.0 - grazing) * gains.plain + grazing * gains.grazing;
}

// Samples first, first + step, ...
struct Series {
    std::uint64_t first, step;
    int count;
};

vec3 by_lobe(const Light& light, const in_double::Metallic& m, const Met& met, const Series& series)
{
    const in_double::mat3 frame = in_double::orthonormal_frame(met.normal);
    const vec3 view = in_double::in_frame(frame, met.view);
    const vec3 stretched = in_double::stretched_view(view, m.alpha);
    const Gains gains = gains_of(m, albedo_at(view.z, m.alpha.x));
    vec3 sum(0.0);
    for (int i = 0; i < series.count; ++i) {
        const vec2 xi = spread_point(series.first + static_cast<std::uint64_t>(i) * series.step);
        const double phi = 2.0 * pi * xi.y;
        const vec3 h =
            in_double::sample_visible_ggx(stretched, m.alpha, {xi.x, std::cos(phi), std::sin(phi)}).normal;
        const double VH = dot(view, h);
        const vec3 L = 2.0 * VH * h - view;
        if (L.z <= 0.0)
            continue;
        sum += in_double::shadowing_ggx(L.z, view.z, m.alpha.x) * reflectance(gains, std::min(VH, 1.0)) *
               light.bilinear(normalize(frame * L));
    }
    return (1.0 / series.count) * sum;
}

vec3 by_peaks(const std::vector<Light::Peak>& peaks, const in_double::Metallic& m, const Met& met)
{
    const double NV = dot(met.normal, met.view);
    const Gains gains = gains_of(m, albedo_at(NV, m.alpha.x));
    vec3 sum(0.0);
    for (const Light::Peak& peak : peaks) {
        const double NL = dot(met.normal, peak.direction);
        if (NL <= 0.0)
            continue;
        const vec3 h = normalize(met.view + peak.direction);
        const double NH = std::clamp(dot(met.normal, h), 0.0, 1.0),
                     VH = std::clamp(dot(met.view, h), 0.0, 1.0);
        const double lobe =
            in_double::density_ggx(NH, m.alpha.x) * in_double::visibility_ggx(NL, NV, m.alpha.x);
        sum += (lobe * NL) * reflectance(gains, VH) * peak.light;
    }
    return sum;
}

// Moments of 4x4 texels: light times direction.
struct Cells {
    std::vector<float> x[3], y[3], z[3];
};

Cells cells_of(const environment::Panorama& p)
{
    Cells cells;
    for (int y = 0; y < p.height; y += 4)
        for (int x = 0; x < p.width; x += 4) {
            vec3 moment[3] = {vec3(0.0), vec3(0.0), vec3(0.0)};
            for (int j = y; j < y + 4; ++j)
                for (int i = x; i < x + 4; ++i) {
                    const environment::Rgb c = p.radiance(i, j);
                    const vec3 d = environment::texel_solid_angle(p, j) *
                                   in_double::direction_from_equirectangular(
                                       {(i + 0.5) / p.width, (j + 0.5) / p.height});
                    moment[0] += static_cast<double>(c.r) * d;
                    moment[1] += static_cast<double>(c.g) * d;
                    moment[2] += static_cast<double>(c.b) * d;
                }
            for (std::size_t k = 0; k < 3; ++k) {
                cells.x[k].push_back(static_cast<float>(moment[k].x));
                cells.y[k].push_back(static_cast<float>(moment[k].y));
                cells.z[k].push_back(static_cast<float>(moment[k].z));
            }
        }
    return cells;
}

vec3 irradiance(const Cells& cells, vec3 n)
{
    const float nx = static_cast<float>(n.x), ny = static_cast<float>(n.y), nz = static_cast<float>(n.z);
    double sums[3];
    for (std::size_t k = 0; k < 3; ++k) {
        double total = 0.0;
        const std::size_t count = cells.x[k].size();
        for (std::size_t row = 0; row < count; row += 256) {
            float sum[8] = {};
            for (std::size_t i = row; i < std::min(row + 256, count); ++i)
                sum[i % 8] += std::max(nx * cells.x[k][i] + ny * cells.y[k][i] + nz * cells.z[k][i], 0.0f);
            for (float part : sum)
                total += static_cast<double>(part);
        }
        sums[k] = total;
    }
    return {sums[0], sums[1], sums[2]};
}

// All that the pixels share.
struct Sources {
    Light whole, cut;
    std::vector<Light::Peak> fine, coarse;
    Cells cells;
};

void fill(const Sources& sources, const scene::Material& material, SphereRays& rays, TruePixel& pixel)
{
    const in_double::Metallic m = metallic_of(material);
    const bool sharp = m.alpha.x < 0.01, narrow = m.alpha.x < 0.08;
    const int across = sharp ? 64 : 8, lobe_samples = 65536 / (across * across);
    const std::uint64_t start = 1000003u * static_cast<std::uint64_t>(pixel.x + 1280 * pixel.y) % 1048576u;
    vec3 specular(0.0), diffuse(0.0), peaks(0.0);
    int peak_count = 0;
    for (int j = 0; j < across * across; ++j) {
        const int column = j % across, row = j / across;
        const auto met = rays.meet(pixel.x + (column + 0.5) / across, pixel.y + (row + 0.5) / across);
        if (!met)
            continue; // a crack between triangles
        specular += by_lobe(sharp ? sources.whole : sources.cut, m, *met,
                            {start + static_cast<std::uint64_t>(j),
                             static_cast<std::uint64_t>(across * across), lobe_samples});
        if (!sharp && (narrow || (column % 2 == row % 2 && row % 2 == 0))) {
            peaks += by_peaks(narrow ? sources.fine : sources.coarse, m, *met);
            ++peak_count;
        }
        if (across == 8 ? (column % 4 == 2 && row % 4 == 2) : (column % 32 == 16 && row % 32 == 16)) {
            const vec2 albedo = albedo_at(dot(met->normal, met->view), m.alpha.x);
            const vec3 under = in_double::reflectance_metallic(m, albedo).diffuse;
            if (m.metalness < 1.0)
                diffuse += (0.25 / pi) * under * irradiance(sources.cells, met->normal);
        }
    }
    pixel.specular = to_glm((1.0 / (across * across)) * specular);
    if (peak_count > 0)
        pixel.specular += to_glm((1.0 / peak_count) * peaks);
    pixel.diffuse = to_glm(diffuse);
}

// The place in the picture of a point, by rays that spread linearly from one origin.
vec2 project(const draw::RayMap& rays, vec3 point)
{
    const vec3 to = point - to_vec(rays.origin);
    const vec3 a = to_vec(rays.direction_dx), b = to_vec(rays.direction_dy), c = to_vec(rays.direction);
    const vec3 n = cross(a, b);
    const double t = dot(to, n) / dot(c, n);
    const vec3 rest = (1.0 / t) * to - c;
    return {dot(rest, a) / dot(a, a), dot(rest, b) / dot(b, b)};
}

} // namespace

std::vector<TruePixel> true_pixels(const scene::Scene& grid, const environment::Panorama& panorama,
                                   const TruthPlan& plan)
{
    Sources sources{light_of(panorama, false), light_of(panorama, true), {}, {}, cells_of(panorama)};
    sources.fine = peaks_of(sources.cut, 4);
    sources.coarse = peaks_of(sources.cut, 2);
    const draw::RayMap map = draw::ray_map(plan.camera, plan.width, plan.height);
    const int spheres = static_cast<int>(grid.instances.size());
    std::vector<TruePixel> pixels(static_cast<std::size_t>(spheres * plan.pixels_per_sphere));
    tbb::parallel_for(0, spheres, [&](int sphere) {
        SphereRays rays(grid, sphere, map);
        const scene::Instance& instance = grid.instances[static_cast<std::size_t>(sphere)];
        const vec3 middle = to_vec(glm::vec3(instance.transform[3]));
        const vec2 place = project(map, middle);
        const double reach = std::abs(project(map, middle + 0.12 * to_vec(plan.camera.right)).x - place.x);
        const auto& material = grid.materials[static_cast<std::size_t>(sphere)];
        int found = 0;
        for (std::uint64_t i = 0; found < plan.pixels_per_sphere; ++i) {
            const vec2 xi = spread_point(i + 977u * static_cast<std::uint64_t>(sphere));
            TruePixel pixel;
            pixel.x = static_cast<int>(place.x + (2.0 * xi.x - 1.0) * reach);
            pixel.y = static_cast<int>(place.y + (2.0 * xi.y - 1.0) * reach);
            pixel.sphere = sphere;
            if (!rays.enter_pixel(pixel.x, pixel.y))
                continue;
            fill(sources, material, rays, pixel);
            rays.leave_pixel();
            pixels[static_cast<std::size_t>(sphere * plan.pixels_per_sphere + found++)] = pixel;
        }
    });
    return pixels;
}

} // namespace lambent::bench
