#include "tests/audit/cached_truth.h"

#include "apps/common/picture_setup.h"
#include "base/text.h"
#include "draw/cpu/cpu_renderer.h"
#include "environment/builtin/builtin.h"
#include "environment/environment.h"
#include "base/hash.h"
#include "reference/tracer.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

namespace lambent::audit::testing {
namespace {

// As the command line understands it.
cli::RenderArguments arguments_of(const Kind& kind, const Size& size)
{
    const std::string pixels = text(size.width, "x", size.height);
    const std::vector<const char*> words = {"lambent", "render", kind.scene.c_str(), "--size", pixels.c_str(),
                                            "-o",      "x.exr"};
    return std::get<cli::RenderArguments>(cli::parse_arguments(static_cast<int>(words.size()), words.data()));
}

image::RadianceImage picture_of(const Kind& kind, const scene::Scene& scene,
                                const image::RadianceImage& panorama, const draw::Settings& settings)
{
    if (kind.samples == 0) {
        const environment::Environment environment =
            environment::make_environment(environment::make_panorama(panorama));
        return draw::make_cpu_renderer(scene)->draw(&environment, settings).radiance;
    }
    reference::Settings how;
    static_cast<view::Picture&>(how) = settings;
    how.bounces = kind.bounces;
    how.samples = kind.samples;
    how.seed = 1;
    return reference::trace(scene, &panorama, how).radiance;
}

std::vector<std::size_t> covered_in(const image::RadianceImage& picture)
{
    std::vector<std::size_t> covered;
    for (std::size_t i = 0; i < picture.values.size() / 4; ++i)
        if (picture.values[4 * i + 3] > 0.0f)
            covered.push_back(i);
    return covered;
}

// Of each of the pixels.
std::vector<reference::PixelEstimate> lights(const Subject& subject, const std::vector<std::size_t>& pixels,
                                             int samples, std::uint32_t seed)
{
    const reference::PixelTracer tracer(subject.scene, &subject.panorama, subject.truth);
    std::vector<reference::PixelEstimate> traced(pixels.size());
    tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
        const int pixel = static_cast<int>(pixels[i]), width = subject.picture.width;
        traced[i] = tracer.estimate({pixel % width, pixel / width, samples, seed});
    });
    return traced;
}

} // namespace

std::string name_of(const Kind& kind)
{
    return text(kind.scene, ", ", kind.environment, ", bounces ", kind.bounces, ", exposure ", kind.exposure,
                kind.samples == 0 ? ", drawn" : text(", ", kind.samples, " samples"));
}

Subject subject_of(const Kind& kind, const Size& size)
{
    const cli::RenderArguments arguments = arguments_of(kind, size);
    Warnings warnings;
    Subject subject;
    subject.scene = cli::load_scene(arguments, warnings);
    draw::Settings settings = arguments.settings;
    settings.camera = cli::choose_camera(arguments, subject.scene);
    subject.panorama = environment::make_builtin(kind.environment);
    subject.picture = picture_of(kind, subject.scene, subject.panorama, settings);
    static_cast<view::Picture&>(subject.truth) = settings;
    subject.truth.bounces = kind.bounces;
    subject.cut = 1.0 / kind.exposure;
    return subject;
}

TrueError true_error(const Subject& subject, int samples)
{
    const std::vector<std::size_t> covered = covered_in(subject.picture);
    std::array<std::vector<reference::PixelEstimate>, 2> light;
    for (std::uint32_t i = 0; i < 2; ++i)
        light[i] = lights(subject, covered, samples, 11 + i);
    double square = 0.0, sum = 0.0;
    for (std::size_t n = 0; n < covered.size(); ++n)
        for (int c = 0; c < 3; ++c) {
            const auto cut = [&](double value) { return std::clamp(value, 0.0, subject.cut); };
            const double p = cut(static_cast<double>(
                             subject.picture.values[4 * covered[n] + static_cast<std::size_t>(c)])),
                         a = cut(light[0][n].radiance[c]), b = cut(light[1][n].radiance[c]);
            square += (p - a) * (p - b);
            sum += 0.5 * (a + b);
        }
    return {covered.size(), 3.0 * static_cast<double>(covered.size()) * square / (sum * sum)};
}

CachedTruth::CachedTruth(const Subject& subject)
    : subject_(subject), number_(subject.picture.values.size() / 4)
{
    const std::vector<std::size_t> covered = covered_in(subject.picture);
    for (std::size_t n = 0; n < covered.size(); ++n)
        number_[covered[n]] = n;
    std::uint32_t seed = 1000;
    for (std::vector<reference::PixelEstimate>& half : half_)
        half = lights(subject, covered, Settings().samples / 2, ++seed);
    for (std::vector<reference::PixelEstimate>& glance : glance_)
        glance = lights(subject, covered, Settings().glance_samples, ++seed);
}

std::optional<Error> CachedTruth::audited(Settings settings) const
{
    settings.cut = subject_.cut;
    std::vector<unsigned char> taken(half_[0].size(),
                                     0); // halves of each pixel; one thread takes all of a pixel
    return measure(subject_.picture, settings, [&](const reference::PixelTracer::Pixel& pixel) {
        const std::size_t n =
            number_[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(subject_.picture.width) +
                    static_cast<std::size_t>(pixel.x)];
        const std::uint32_t random = hashed(settings.seed, static_cast<std::uint32_t>(n));
        if (pixel.samples == settings.glance_samples)
            return glance_[random % glances][n];
        const unsigned step = 1 + 2 * (random / halves % (halves / 2)); // odd: the four are different
        return half_[(random + step * taken[n]++) % halves][n];
    });
}

} // namespace lambent::audit::testing
