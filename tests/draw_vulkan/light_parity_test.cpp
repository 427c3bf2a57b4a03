// The lighting passes on a Vulkan device against the same passes on the processor's lanes, fragment by fragment. What the
// passes compute has its witnesses elsewhere; this is about lookups, layouts and bindings.
#include "draw/cpu/light_kernel.h"
#include "draw/cpu/specular_kernel.h"
#include "draw/vulkan/filled_buffer.h"
#include "draw/vulkan/passes.h"
#include "draw/vulkan/environment_on_device.h"
#include "draw/vulkan/picture_on_device.h"
#include "draw/vulkan/tile_on_device.h"
#include "environment/builtin/builtin.h"
#include "environment/panorama/panorama.h"
#include "tests/draw/test_scenes.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>

namespace lambent::draw {
namespace {

using glm::vec3;

// Points that look like those of pictures: normals that face the viewer, footprints of all sizes.
class Maker {
public:
    Fragments fragments(std::size_t count)
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
            put(f, column_position, at, 2.0f * direction());
            put(f, column_view, at, view);
            put(f, column_shine, at, normal);
            const vec3 mirrored = 2.0f * glm::dot(normal, view) * normal - view;
            put(f, column_shine + 3, at, footprint(mirrored));
            put(f, column_shine + 6, at, footprint(mirrored));
            put(f, column_base_color, at, {unit(), unit(), unit()});
            put(f, column_diffuse, at, {unit(), unit(), unit()});
            put(f, column_specular, at, {unit(), unit(), unit()});
            const float roughness = unit();
            f[column_exponent][at] = std::pow(10.0f, -1.0f + 6.0f * unit());
            f[column_alpha][at] = std::max(roughness * roughness, 1e-4f);
            f[column_metallic][at] = unit();
            f[column_occlusion][at] = unit();
            f[column_opacity][at] = 1.0f;
            f[column_lit][at] = 1.0f;
            put(f, column_emissive, at, vec3(0.0f));
            for (int c = column_direct; c < columns_of_light_end; ++c)
                f[c][at] = 0.0f;
        }
        return f;
    }

private:
    static void put(Fragments& f, int first, std::size_t at, const vec3& v)
    {
        for (int i = 0; i < 3; ++i)
            f[first + i][at] = v[i];
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

// The passes of light over given fragments, as pictures run them over theirs.
class LightOnDevice {
public:
    LightOnDevice(const vulkan::Device& device, const Surroundings& setup, std::size_t room)
        : device_(device), cache_(device, {}), layout_(pass_layout(device)),
          passes_(cache_, *layout_, {1, setup.context.model, setup.context.mip_level}),
          picture_(device, setup.context, setup.tables, setup.lights), on_device_(device, setup.context),
          tile_(device, {64, 64, 1, 0, room}), nothing_(filled_buffer(device, std::vector<float>(16))),
          lights_(!setup.lights.empty()), environment_(setup.context.environment != nullptr)
    {
        std::array<vulkan::Resource, gpu_layout::binding_count> resources{};
        for (int binding = gpu_layout::binding_instances; binding <= gpu_layout::binding_codes; ++binding)
            resources[static_cast<std::size_t>(binding)].buffer = &nothing_;
        picture_.offer(resources);
        on_device_.offer(resources);
        tile_.offer(resources);
        set_ = std::make_unique<vulkan::BindingSet>(device, *layout_, resources);
    }

    void light(Fragments& fragments)
    {
        const std::size_t room = tile_.shape().capacity;
        std::vector<float> values(room * gpu_layout::column_count, 0.0f);
        const auto column = [&](int i) { return values.begin() + static_cast<std::ptrdiff_t>(room) * i; };
        for (int i = 0; i < column_count; ++i)
            std::copy_n(fragments[i], fragments.size(), column(i));
        run(values, static_cast<std::uint32_t>(fragments.size()));
        for (int i = column_direct; i < columns_of_light_end; ++i)
            std::copy_n(column(i), fragments.size(), fragments[i]);
    }

private:
    void run(std::vector<float>& values, std::uint32_t count)
    {
        const std::size_t bytes = values.size() * sizeof(float);
        const vulkan::Buffer from(device_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                  vulkan::MemoryKind::upload),
            back(device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::MemoryKind::readback);
        std::memcpy(from.memory().data(), values.data(), bytes);
        gpu_layout::PictureRecord record = picture_.record();
        record.fragments.x = static_cast<int>(tile_.shape().capacity);
        const std::array<std::uint32_t, gpu_layout::counter_count> counters = {(count + 63) / 64, 1, 1,
                                                                               count};
        vulkan::Commands commands(device_);
        commands.copy(from, tile_.values(), bytes);
        commands.write(tile_.picture(), std::as_bytes(std::span(&record, 1)));
        commands.write(tile_.counters(), std::as_bytes(std::span(counters)));
        const std::array<std::byte, sizeof(gpu_layout::RasterConstants)> none{};
        for (const int pass : {gpu_layout::pass_direct, gpu_layout::pass_ambient, gpu_layout::pass_specular})
            if (pass == gpu_layout::pass_direct ? lights_ : environment_)
                commands.dispatch_indirect(passes_.light(pass), *set_, none, {tile_.counters(), 0});
        commands.copy(tile_.values(), back, bytes);
        commands.run();
        std::memcpy(values.data(), back.memory().data(), bytes);
    }

    const vulkan::Device& device_;
    vulkan::PipelineCache cache_;
    std::unique_ptr<vulkan::ShaderLayout> layout_;
    Passes passes_;
    PictureOnDevice picture_;
    EnvironmentOnDevice on_device_;
    TileOnDevice tile_;
    vulkan::Buffer nothing_;
    bool lights_, environment_;
    std::unique_ptr<vulkan::BindingSet> set_;
};

struct Difference {
    double relative_rmse, mean;
};

Difference difference(const Fragments& found, const Fragments& wanted, int first)
{
    double squares = 0.0, sum = 0.0;
    const double count = 3.0 * static_cast<double>(wanted.size());
    for (int c = 0; c < 3; ++c)
        for (std::size_t at = 0; at < wanted.size(); ++at) {
            const auto a = static_cast<double>(found[first + c][at]),
                       b = static_cast<double>(wanted[first + c][at]);
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
        Fragments here = Maker().fragments(count), there = Maker().fragments(count);
        light_directly(setup.context, setup.lights, 0, count, here);
        light_ambiently(setup.context, 0, count, here);
        light_specularly(setup.context, 0, count, here);
        LightOnDevice(compute_->device(), setup, count).light(there);
        for (const auto& [name, column] :
             {std::pair("direct", column_direct), std::pair("irradiance", column_irradiance),
              std::pair("ambient", column_ambient), std::pair("specular", column_reflected)}) {
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

// So many that they are looked through in several rounds; a few reach each group of fragments.
TEST_F(LightParity, ManyLightsOfShortRange)
{
    Surroundings setup(testing::white_environment(), Model::ggx, MipLevel::matched, 4);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-2.0f, 2.0f), range(0.1f, 0.6f);
    for (int i = 0; i < 2500; ++i) {
        LightSource light;
        light.local = true;
        light.position = {place(random), place(random), place(random)};
        light.intensity = {0.1f, 0.2f, 0.3f};
        light.range = range(random);
        setup.lights.push_back(light);
    }
    constexpr std::size_t count = 1000; // the last group is not full
    Fragments here = Maker().fragments(count), there = Maker().fragments(count);
    light_directly(setup.context, setup.lights, 0, 1008, here);
    LightOnDevice(compute_->device(), setup, count).light(there);
    EXPECT_LE(difference(there, here, column_direct).relative_rmse, 1e-4);
    EXPECT_EQ(compute_->complaints(), std::vector<std::string>());
}

TEST_F(LightParity, WithoutAnEnvironmentOnlyLights)
{
    Surroundings setup(testing::white_environment(), Model::ggx, MipLevel::matched, 4);
    setup.context.environment = nullptr;
    Fragments here = Maker().fragments(128), there = Maker().fragments(128);
    light_directly(setup.context, setup.lights, 0, 128, here);
    LightOnDevice stage(compute_->device(), setup, 1024);
    stage.light(there);
    EXPECT_LE(difference(there, here, column_direct).relative_rmse, 1e-4);
    EXPECT_EQ(there[column_reflected][0], 0.0f);
    // More fragments than before, in the same room.
    Fragments more = Maker().fragments(1024);
    stage.light(more);
    EXPECT_EQ(more[column_direct][5], there[column_direct][5]);
    EXPECT_EQ(compute_->complaints(), std::vector<std::string>());
}

} // namespace
} // namespace lambent::draw
