#include "tests/image/hostile.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <random>

namespace lambent::test {
namespace {

const std::string name = "folder/bad.bin";

enum class Outcome { read, refused, broken };

// Whether the decoder kept its promise, and how.
Outcome outcome_of(const Decoder& decode, std::span<const std::uint8_t> bytes, std::string& line)
{
    try {
        decode(bytes, name);
        return Outcome::read;
    } catch (const Error& error) {
        line = error.what();
        const bool one_line = line.find('\n') == std::string::npos && line.starts_with(name + ": ");
        return one_line && error.failure() == Failure::bad_input ? Outcome::refused : Outcome::broken;
    } catch (const std::exception& error) {
        line = std::string("not an Error: ") + error.what();
        return Outcome::broken;
    }
}

} // namespace

void expect_refused(const Decoder& decode, std::span<const std::uint8_t> bytes, const std::string& reason)
{
    std::string line;
    EXPECT_EQ(outcome_of(decode, bytes, line), Outcome::refused) << line << " (wanted: " << reason << ")";
    EXPECT_PRED2([](const auto& text, const auto& part) { return text.find(part) != std::string::npos; },
                 line, reason);
}

void expect_truncations_refused(const Decoder& decode, std::span<const std::uint8_t> valid, std::size_t tail)
{
    std::string line;
    ASSERT_EQ(outcome_of(decode, valid, line), Outcome::read) << line;
    for (std::size_t length = 0; length + tail < valid.size(); ++length) {
        // A copy of just that length: whoever reads beyond it is seen by AddressSanitizer.
        const Bytes cut(valid.begin(), valid.begin() + static_cast<std::ptrdiff_t>(length));
        ASSERT_EQ(outcome_of(decode, cut, line), Outcome::refused)
            << "cut to " << length << " of " << valid.size() << " bytes: " << line;
    }
}

void expect_mutations_survived(const Decoder& decode, std::span<const std::uint8_t> valid, int count)
{
    std::string line;
    ASSERT_EQ(outcome_of(decode, valid, line), Outcome::read) << line;
    std::minstd_rand random(7);
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        Bytes bytes(valid.begin(), valid.end());
        const auto changes = 1 + random() % 8;
        for (unsigned change = 0; change < changes; ++change) {
            std::uint8_t& byte = bytes[random() % bytes.size()];
            const bool one_bit = random() % 2 == 0;
            byte = static_cast<std::uint8_t>(one_bit ? byte ^ (1u << random() % 8) : random() % 256);
        }
        const Outcome outcome = outcome_of(decode, bytes, line);
        ASSERT_NE(outcome, Outcome::broken) << "mutation " << i << ": " << line;
        refused += outcome == Outcome::refused;
    }
    EXPECT_GT(refused, 0);
}

} // namespace lambent::test
