// The promise of an interval: it holds the true error of 95 in 100 pictures, whatever is wrong with them.
#include "tests/audit/cached_truth.h"

#include <tbb/parallel_for.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace lambent::audit::testing {
namespace {

// Faults of all sorts: edges and small highlights, in which half a percent of the pixels hold nearly all of the error;
// shadows and mirrored light that are missing nearly everywhere; noise that is like the audit's own.
const std::vector<Kind> kinds = {
    {"report", "kitchen", 0, 1.0},   {"grid", "kitchen", 8, 1.0},        {"teapot", "sky", 8, 0.5},
    {"sphere", "studio", 1, 3.0, 4}, {"painted", "kitchen", 8, 1.0, 16},
};

struct Share {
    int inside = 0, audits = 0;

    void add(bool holds)
    {
        inside += holds ? 1 : 0;
        ++audits;
    }
    double value() const { return static_cast<double>(inside) / audits; }
};

// Share of audits, each of its own pixels and noise, whose interval holds the error.
Share share_of(const CachedTruth& truth, double error, int audits)
{
    Settings settings;
    settings.pixels = 128; // a tenth of the covered pixels, not all of them
    std::vector<char> holds(static_cast<std::size_t>(audits));
    tbb::parallel_for(0, audits, [&](int i) {
        Settings other = settings;
        other.seed = static_cast<std::uint32_t>(i);
        const std::optional<Error> said = truth.audited(other);
        holds[static_cast<std::size_t>(i)] = said && said->low <= error && error <= said->high;
    });
    Share share;
    for (const char one : holds)
        share.add(one != 0);
    return share;
}

// Of 750 intervals that each hold the error with a probability between .93 and .97, the share is outside of .895 to
// .992 with a probability below 1e-4; of the 150 of one kind, with .90 to .99, outside of .80 to 1 with one below 1e-4.
// (Binomial, normal: 3.75 standard deviations.)
TEST(Audit, intervals_hold_the_error_of_95_in_100_pictures)
{
    Share all;
    for (const Kind& kind : kinds) {
        const Subject subject = subject_of(kind, {96, 54});
        const TrueError error = true_error(subject, 256);
        const Share share = share_of(CachedTruth(subject), error.relative_rmse(), 150);
        std::cout << name_of(kind) << ": " << error.covered << " pixels, error " << error.relative_rmse()
                  << ", held in " << share.value() << "\n";
        EXPECT_GE(share.value(), 0.80) << name_of(kind);
        all.inside += share.inside;
        all.audits += share.audits;
    }
    EXPECT_GE(all.value(), 0.895);
    EXPECT_LE(all.value(), 0.992);
}

} // namespace
} // namespace lambent::audit::testing
