// An environment as bytes, for a cache on this machine: not a format for anybody else.
#pragma once

#include "base/error.h"
#include "environment/environment.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lambent::environment {

/// What making an environment gave: warnings belong to it, for they have to be given again.
struct MadeEnvironment {
    Environment environment;
    Warnings warnings;
};

std::vector<std::uint8_t> to_bytes(const MadeEnvironment& made);

/// Nothing if the bytes are not what to_bytes() gave, whole: they carry a checksum.
std::optional<MadeEnvironment> from_bytes(std::span<const std::uint8_t> bytes);

} // namespace lambent::environment
