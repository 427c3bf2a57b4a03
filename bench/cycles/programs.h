// The two programs, given the same scene, panorama, size and number of bounces.
#pragma once

#include "bench/cycles/white_grid.h"
#include "image/image.h"
#include "tests/support/process.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lambent::bench {

/// Is `blender` there, and of the series this was made for?
bool have_blender();

/// What a sphere does with light.
enum class Lobe {
    /// Cycles: a walk between facets [Heitz et al. 2016]; lambent: one reflection, scaled [Turquin 2019].
    multiple,
    /// One reflection; Cycles 3.4 multiplies masking by shadowing, lambent correlates them by height.
    separable,
    /// One reflection, the same in both: when facets are nearly black that is all that is left of Cycles' walk, as
    /// each further one is darker by their reflectance. The picture is made brighter again. One bounce only.
    single
};

struct Job {
    std::string environment; ///< of lambent's names, or a file
    PictureSize size{320, 180};
    int bounces = 8; ///< at least 1
    Lobe lobe = Lobe::multiple;
    bool adaptive = false; ///< Cycles only: its adaptive sampling
    int threads = 2;
};

struct Order {
    int samples;
    std::uint32_t seed;
};

/// A picture and what it took: from the scene as the program holds it to the finished picture.
struct Taken {
    image::RadianceImage radiance;
    double seconds = 0.0;     ///< wall clock
    double cpu_seconds = 0.0; ///< of all threads
};

struct Series {
    std::vector<Taken> pictures;
    double start_seconds = 0.0; ///< wall clock of a process outside of those pictures
};

/// Writes the scene once, then has pictures made of it. Ends the program with a message where one fails.
class Programs {
public:
    explicit Programs(const Job& job);

    Series lambent(const std::vector<Order>& orders) const;
    Series cycles(const std::vector<Order>& orders) const;
    const scene::Scene& grid() const { return grid_; }

private:
    std::string job_text(const std::vector<Order>& orders) const;
    Taken one_of_lambent(const Order& order, double& start_seconds) const;
    std::string output(std::size_t number) const;

    Job job_;
    scene::Scene grid_;
    testing::Folder folder_;
};

} // namespace lambent::bench
