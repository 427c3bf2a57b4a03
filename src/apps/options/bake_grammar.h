// The part of the command line that belongs to `lambent bake`.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/grammar.h"

namespace lambent::cli {

/// Must outlive the parsing, which fills its members.
class BakeGrammar {
public:
    /// Adds the command.
    void add(Command& app);

    bool parsed() const { return command_.parsed(); }

    /// Throws Error(usage).
    BakeArguments result() const;

private:
    void add_light(Command command);
    void add_files(Command command);
    void apply_light(BakeArguments& arguments) const;
    void apply_error(environment::BakeOptions& options) const;
    void apply_files(BakeArguments& arguments) const;
    void apply_pictures(BakeArguments& arguments) const;
    void apply_texels(BakeArguments& arguments) const;

    Command command_;
    CommonWords common_;
    BakeArguments arguments_;
    std::string size_, irradiance_, specular_, error_, samples_, table_, roughness_, rotation_, backend_;
    std::string format_, layout_, texels_;
    bool no_cache_ = false;
};

} // namespace lambent::cli
