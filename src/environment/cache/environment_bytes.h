// An environment as bytes, for a cache on one machine; not an exchange format.
#pragma once

#include "base/error.h"
#include "environment/environment.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lambent::environment {

/// A prepared environment and the warnings of preparing it, which are repeated when it comes from the cache.
struct MadeEnvironment {
    Environment environment;
    Warnings warnings;
};

std::vector<std::uint8_t> to_bytes(const MadeEnvironment& made);

/// Returns nothing unless the bytes are a complete result of to_bytes(), by their checksum.
std::optional<MadeEnvironment> from_bytes(std::span<const std::uint8_t> bytes);

} // namespace lambent::environment
