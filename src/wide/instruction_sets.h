// Which of the processor's instructions are used: all of them, unless LAMBENT_ISA says less. For tests, which so see on
// one machine what others draw.
#pragma once

#include <string>
#include <vector>

namespace lambent::wide {

/// The environment variable that limits programs: one of instruction_sets(), or empty.
inline constexpr const char* limit_variable = "LAMBENT_ISA";

/// Generations of processors by their newest instructions, oldest first, as Embree names them: sse2, sse4.2, avx, avx2
/// and avx512. Kernels have targets of their own: the portable fallback for sse2, SSE4 up to avx.
const std::vector<std::string>& instruction_sets();

/// Those that this processor has.
std::vector<std::string> available_instruction_sets();

/// From now on nothing newer than `name` is used; empty: everything is. Not while something is computed. Throws
/// Error(usage) for an unknown name, Error(no_device) for one that this processor lacks.
void limit_instructions(const std::string& name);

/// limit_instructions() to what LAMBENT_ISA says, if it is set.
void limit_instructions_by_environment();

/// What limit_instructions() was given last; empty: no limit.
const std::string& instruction_limit();

} // namespace lambent::wide
