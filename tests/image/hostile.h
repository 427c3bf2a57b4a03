// What every decoder must do with bad bytes: say so in one line, or read them; never anything else.
#pragma once

#include "tests/image/bytes.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace lambent::test {

using Decoder = std::function<void(std::span<const std::uint8_t> bytes, const std::string& name)>;

/// Calls the decoder and checks that it refuses as promised: Error(bad_input) with one line that starts
/// with the name and contains `reason`.
void expect_refused(const Decoder& decode, std::span<const std::uint8_t> bytes, const std::string& reason);

/// Every shorter file must be refused. `tail` bytes at the end may be missing.
void expect_truncations_refused(const Decoder& decode, std::span<const std::uint8_t> valid,
                                std::size_t tail = 0);

/// Decodes `count` files that differ from the valid one in one to eight random bits or bytes. Each is
/// refused as promised or read. At least one must be refused, else the test would prove nothing.
void expect_mutations_survived(const Decoder& decode, std::span<const std::uint8_t> valid, int count);

} // namespace lambent::test
