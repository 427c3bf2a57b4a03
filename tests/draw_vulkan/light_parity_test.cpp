// The lighting passes on a Vulkan device against the same passes on the processor's lanes, fragment by fragment. What the
// passes compute has its witnesses elsewhere; this is about lookups, layouts and bindings.
#include "draw/vulkan/light_stage.h"
#include "environment/builtin.h"
#include "environment/panorama.h"
#include "tests/draw/test_scenes.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace lambent::draw {
namespace {

using glm::vec3;

// Points that look like those of pictures: normals that face the viewer, footprints of all sizes.
class Maker {
public:
    Fragments fragments(std::size_t count, Model model)
    {
        Fragments f;
        f.resize(count);
        for (std::size_t at = 0; at < count; ++at) {
            const vec3 normal = direction();
            vec3 view = direction();
            if (glm::dot(view, normal) < 0.0f)
                view = -view;
            if (glm::dot(view, normal) < 0.02f)
                view = normal;
            put(f, position_x, at, 2.0f * direction());
            put(f, view_x, at, view);
            put(f, shading_x, at, normal);
            const vec3 mirrored = 2.0f * glm::dot(normal, view) * normal - view;
            put(f, mirrored_dx_x, at, footprint(mirrored));
            put(f, mirrored_dy_x, at, footprint(mirrored));
            put(f, base_r, at, {unit(), unit(), unit()});
            put(f, specular_r, at, {unit(), unit(), unit()});
            const float roughness = unit();
            f[gloss][at] = model == Model::phong ? std::pow(10.0f, -1.0f + 6.0f * unit())
                                                 : std::max(roughness * roughness, 1e-4f);
            f[metalness][at] = unit();
            f[occlusion][at] = unit();
            for (const Column c : {direct_r, irradiance_r, ambient_r, reflected_r})
                put(f, c, at, vec3(0.0f));
        }
        return f;
    }

private:
    static void put(Fragments& f, Column first, std::size_t at, const vec3& v)
    {
        for (int i = 0; i < 3; ++i)
            f[Column(first + static_cast<std::size_t>(i))][at] = v[i];
    }

    float unit() { return std::uniform_real_distribution<float>(0.0f, 1.0f)(random_); }

    vec3 direction()
    {
        std::normal_distribution<float> normal;
        return glm::normalize(vec3(normal(random_), normal(random_), normal(random_)));
    }

    vec3 footprint(const vec3& about)
    {
        const vec3 across = glm::cross(about, direction());
        return std::pow(10.0f, -4.0f + 3.0f * unit()) * across;
    }

    std::mt19937 random_{7};
};

// Everything that a picture would bring along.
struct Surroundings {
    environment::Environment environment;
    std::vector<environment::Panorama> mips;
    SampleTables tables;
    LightContext context;
    std::vector<LightSource> lights;

    Surroundings(environment::Environment&& given, Model model, MipLevel levels, int samples)
        : environment(std::move(given)),
          tables(make_sample_tables(samples,
                                    levels == MipLevel::report ? LobePoints::hammersley : LobePoints::spiral))
    {
        if (levels == MipLevel::report)
            mips = environment::mip_chain(environment.panorama);
        context.model = model;
        context.mip_level = levels;
        context.ambient_brightness = 1.5f;
        context.environment = &environment;
        context.mip_chain = &mips;
        context.across = glm::normalize(vec3(1.0f, 0.2f, -0.4f));
        context.rotation_cosine = std::cos(0.7f);
        context.rotation_sine = std::sin(0.7f);
        context.tables = &tables;
        LightSource sun, bulb, spot;
        sun.axis = glm::normalize(vec3(0.3f, -0.9f, 0.2f));
        sun.intensity = {3.0f, 2.5f, 2.0f};
        bulb.local = true;
        bulb.position = {0.5f, 3.0f, -0.5f};
        bulb.intensity = {4.0f, 5.0f, 6.0f};
        bulb.range = 8.0f;
        spot = bulb;
        spot.position = {-3.0f, 0.0f, 0.5f};
        spot.axis = {1.0f, 0.0f, 0.0f};
        spot.range = std::numeric_limits<float>::infinity();
        spot.cos_inner = 0.9f;
        spot.cos_outer = 0.5f;
        lights = {sun, bulb, spot};
    }
};

struct Difference {
    double relative_rmse, mean;
};

Difference difference(const Fragments& found, const Fragments& wanted, Column first)
{
    double squares = 0.0, sum = 0.0;
    const double count = 3.0 * static_cast<double>(wanted.size());
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t at = 0; at < wanted.size(); ++at) {
            const auto a = static_cast<double>(found[Column(first + c)][at]),
                       b = static_cast<double>(wanted[Column(first + c)][at]);
            squares += (a - b) * (a - b);
            sum += b;
        }
    return {std::sqrt(squares / count) / (sum / count), sum / count};
}

class LightParity : public ::testing::Test {
protected:
    void SetUp() override
    {
        compute_ = test::Compute::open();
        if (!compute_) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }

    // Lights the same fragments twice and bounds the difference of each pass.
    void expect_parity(const Surroundings& setup, double bound)
    {
        constexpr std::size_t count = 4096;
        Fragments here = Maker().fragments(count, setup.context.model),
                  there = Maker().fragments(count, setup.context.model);
        light_directly(setup.context, setup.lights, 0, count, here);
        light_ambiently(setup.context, 0, count, here);
        light_specularly(setup.context, 0, count, here);
        const vulkan::PipelineCache cache(compute_->device(), {});
        LightStage stage(compute_->device(), cache, setup.context, setup.lights);
        stage.light(there);
        for (const auto& [name, column] :
             {std::pair("direct", direct_r), std::pair("irradiance", irradiance_r),
              std::pair("ambient", ambient_r), std::pair("specular", reflected_r)}) {
            const Difference d = difference(there, here, column);
            std::printf("%s %s: %.2e of %.3g\n", compute_->device_name().c_str(), name, d.relative_rmse,
                        d.mean);
            EXPECT_GT(d.mean, 0.0) << name;
            EXPECT_LE(d.relative_rmse, bound) << name;
        }
        EXPECT_EQ(compute_->complaints(), std::vector<std::string>());
    }

    std::unique_ptr<test::Compute> compute_;
};

environment::Environment kitchen()
{
    return environment::make_environment(environment::make_panorama(environment::make_builtin("kitchen")));
}

constexpr double usual_bound = 2e-3;

TEST_F(LightParity, GgxSampled)
{
    expect_parity(Surroundings(kitchen(), Model::ggx, MipLevel::matched, 40), usual_bound);
}

TEST_F(LightParity, GgxSplitSum)
{
    expect_parity(Surroundings(kitchen(), Model::ggx, MipLevel::matched, split_sum_samples), usual_bound);
}

TEST_F(LightParity, PhongMatched)
{
    expect_parity(Surroundings(kitchen(), Model::phong, MipLevel::matched, 40), usual_bound);
}

TEST_F(LightParity, PhongAsTheReport)
{
    expect_parity(Surroundings(kitchen(), Model::phong, MipLevel::report, 40), usual_bound);
}

TEST_F(LightParity, WithoutAnEnvironmentOnlyLights)
{
    Surroundings setup(testing::white_environment(), Model::ggx, MipLevel::matched, 4);
    setup.context.environment = nullptr;
    Fragments here = Maker().fragments(128, Model::ggx), there = Maker().fragments(128, Model::ggx);
    light_directly(setup.context, setup.lights, 0, 128, here);
    const vulkan::PipelineCache cache(compute_->device(), {});
    LightStage stage(compute_->device(), cache, setup.context, setup.lights);
    stage.light(there);
    EXPECT_LE(difference(there, here, direct_r).relative_rmse, 1e-4);
    EXPECT_EQ(there[reflected_r][0], 0.0f);
    // More fragments than before, in the same stage.
    Fragments more = Maker().fragments(1024, Model::ggx);
    stage.light(more);
    EXPECT_EQ(more[direct_r][5], there[direct_r][5]);
    EXPECT_EQ(compute_->complaints(), std::vector<std::string>());
}

} // namespace
} // namespace lambent::draw
