#include "wide/instruction_sets.h"

#include "base/error.h"
#include "base/text.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace lambent::wide {
namespace {

struct InstructionSet {
    const char* name;
    std::int64_t best; ///< Highway's target with these instructions; better ones have lower bits
    bool (*is_available)();
};

const std::vector<InstructionSet>& sets()
{
#if HWY_ARCH_X86
    static const std::vector<InstructionSet> all = {
        {"sse2", HWY_EMU128, [] { return true; }},
        {"sse4.2", HWY_SSE4, [] { return __builtin_cpu_supports("sse4.2") != 0; }},
        {"avx", HWY_SSE4, [] { return __builtin_cpu_supports("avx") != 0; }},
        {"avx2", HWY_AVX2, [] { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }},
        {"avx512", HWY_AVX3_DL,
         [] {
             return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
         }},
    };
#else
    static const std::vector<InstructionSet> all; // no choice on other architectures
#endif
    return all;
}

std::string& limit()
{
    static std::string name;
    return name;
}

template <class Wanted>
std::vector<std::string> names_of(const Wanted& wanted)
{
    std::vector<std::string> names;
    for (const InstructionSet& set : sets())
        if (wanted(set))
            names.emplace_back(set.name);
    return names;
}

} // namespace

const std::vector<std::string>& instruction_sets()
{
    static const std::vector<std::string> names = names_of([](const InstructionSet&) { return true; });
    return names;
}

std::vector<std::string> available_instruction_sets()
{
    return names_of([](const InstructionSet& set) { return set.is_available(); });
}

void limit_instructions(const std::string& name)
{
    std::int64_t newer = 0;
    if (!name.empty()) {
        const auto set =
            std::find_if(sets().begin(), sets().end(), [&](const auto& each) { return name == each.name; });
        if (set == sets().end()) {
            std::string known;
            for (const std::string& each : instruction_sets())
                known += (known.empty() ? "" : ", ") + each;
            throw Error(Failure::usage,
                        text(limit_variable, ": unknown instruction set '", name, "' (", known, ")"));
        }
        if (!set->is_available())
            throw Error(Failure::no_device, text(limit_variable, ": this processor has no ", name));
        newer = set->best - 1;
    }
    hwy::DisableTargets(newer);
    hwy::GetChosenTarget().DeInit();
    limit() = name;
}

void limit_instructions_by_environment()
{
    if (const char* const name = std::getenv(limit_variable))
        limit_instructions(name);
}

const std::string& instruction_limit()
{
    return limit();
}

} // namespace lambent::wide
