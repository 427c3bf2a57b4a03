// The part of the command line that says what a picture shows: the same for all commands that show a scene.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/grammar.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::cli {

/// Words as given; the parsing fills these, and an empty one was not given.
struct PictureWords : CommonWords {
    std::string size, camera, target, fov, aa, animation, moment;
    std::string rotation, background, ambient, ibl, samples;
    std::string model, roughness, mip_level, alpha, kd, ks, density;
    std::string exposure, contrast, tone, space;
    std::string backend;
    std::vector<std::string> lights;
    bool no_cache = false, no_compensation = false;

    /// Those with one word that were given: the option's name without dashes, and the word.
    std::vector<std::pair<std::string, std::string>> given() const;
};

/// Must outlive the parsing, which fills its members.
class PictureGrammar {
public:
    /// Adds the scene and the options to a command.
    void add(Command& command);

    /// Without an output. Throws Error(usage).
    RenderArguments result() const;

    /// Makes a result one of the report's own order of things. Throws Error(usage) for what it does not go with.
    void use_report_pipeline(RenderArguments& arguments) const;

    /// The same for viewers, with the words. Throws Error(usage).
    StartArguments start() const;

private:
    PictureWords words_;
    RenderArguments arguments_;
};

} // namespace lambent::cli
