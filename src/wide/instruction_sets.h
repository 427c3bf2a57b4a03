// Selects the processor's instructions that are used: all of them, unless LAMBENT_ISA limits them, so that tests can
// compute on one machine what other processors would.
#pragma once

#include <string>
#include <vector>

namespace lambent::wide {

/// The environment variable that limits programs: one of instruction_sets(), or empty.
inline constexpr const char* limit_variable = "LAMBENT_ISA";

/// Generations of processors by their newest instructions, oldest first, as Embree names them: sse2, sse4.2, avx, avx2
/// and avx512. Kernels have targets of their own: the portable fallback for sse2, SSE4 up to avx.
const std::vector<std::string>& instruction_sets();

/// The instruction sets that this processor has.
std::vector<std::string> available_instruction_sets();

/// Limits kernels to instructions no newer than `name`; an empty name removes the limit. Must not be called while
/// kernels run. Throws Error(usage) for an unknown name, Error(no_device) for one that this processor lacks.
void limit_instructions(const std::string& name);

/// Calls limit_instructions() with the value of LAMBENT_ISA, if it is set.
void limit_instructions_by_environment();

/// The name last given to limit_instructions(); empty: no limit.
const std::string& instruction_limit();

} // namespace lambent::wide
