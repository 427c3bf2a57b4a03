// Pictures, a trace and a bake by the finished program, small enough for emulators, and how far two of them are apart.
#pragma once

#include "tests/support/process.h"

#include <string>
#include <vector>

namespace lambent::processors {

/// Words before the program's own: who runs it. Empty: the system.
using Runner = std::vector<std::string>;

/// Runs it with LAMBENT_ISA set.
Runner limited_to(const std::string& instruction_set);

/// Numbers of everything that a command wrote, in order: linear light.
using Values = std::vector<float>;

/// All of them, by one runner. What could not be made fails the test and is empty.
struct Works {
    Values picture, light, trace, bake;
};

/// A folder with a panorama: sky, ground and a small sun 250 times as bright.
class Workshop {
public:
    Workshop();

    /// Of 65x36 pixels: a sphere, a teapot and a plane under the panorama, with lamps.
    Values picture(const Runner& runner) const;
    /// The same with shadows and light from surface to surface.
    Values light(const Runner& runner) const;
    /// The same, path-traced, one path per pixel, two bounces.
    Values trace(const Runner& runner) const;
    /// Irradiance, specular levels and the split-sum table.
    Values bake(const Runner& runner) const;
    Works all(const Runner& runner) const
    {
        return {picture(runner), light(runner), trace(runner), bake(runner)};
    }

    /// The command behind these, for other runners: "render", "reference", "bake", or "light" for the picture with shadows.
    /// `output` is in the folder.
    std::vector<std::string> words(const std::string& command, const std::string& output) const;
    std::string path(const std::string& name) const { return folder_.path(name); }

private:
    Values written(const Runner& runner, const std::string& command) const;

    testing::Folder folder_;
};

/// Runs the program with these words.
testing::Outcome run(const Runner& runner, const std::vector<std::string>& words);

/// Root mean square of a - b over that of b; 1 where their sizes differ.
double distance(const Values& a, const Values& b);

/// Share of the values of a that differ from those of b by more than `bound` times the larger of the two, or of the mean of
/// b. 1 where their sizes differ.
double share_beyond(const Values& a, const Values& b, double bound);

} // namespace lambent::processors
