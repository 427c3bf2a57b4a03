// Prints how often intervals hold the error, by kind of picture: the table of docs/AUDIT.md. Takes some minutes.
//     audit_coverage [WIDTH HEIGHT [LONG_SAMPLES [AUDITS]]]
#include "tests/audit/cached_truth.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace lambent::audit::testing {
namespace {

const std::vector<Kind> kinds = {
    {"report", "kitchen", 0, 1.0},    {"grid", "kitchen", 8, 1.0},        {"teapot", "studio", 0, 1.0},
    {"report", "sky", 8, 1.0},        {"sphere", "sky", 1, 1.0},          {"grid", "kitchen", 0, 1.0},
    {"teapot", "kitchen", 8, 1.0, 8}, {"painted", "kitchen", 8, 0.5, 16}, {"grid", "studio", 1, 2.0, 64},
    {"painted", "sky", 0, 1.0},       {"report", "kitchen", 8, 3.0},      {"furnace", "furnace", 8, 0.7},
};

struct Row {
    double held = 0.0, below = 0.0, above = 0.0; ///< shares: error in the interval, below it, above it
    double width = 0.0;                          ///< of the interval, over the error, mean
    double bias = 0.0;                           ///< of relative_mse, over its value
};

Row row_of(const Subject& subject, const TrueError& truth, int audits)
{
    Row row;
    for (int i = 0; i < audits; ++i) {
        Settings settings;
        settings.cut = subject.cut;
        settings.seed = static_cast<std::uint32_t>(i);
        const Error e =
            measure(subject.scene, &subject.panorama, subject.truth, subject.picture, settings).value();
        const double error = truth.relative_rmse();
        row.below += error < e.low;
        row.above += error > e.high;
        row.width += (e.high - e.low) / error;
        row.bias += e.relative_mse / truth.relative_mse - 1.0;
    }
    for (double* sum : {&row.below, &row.above, &row.width, &row.bias})
        *sum /= audits;
    row.held = 1.0 - row.below - row.above;
    return row;
}

void print(const Size& size, int long_samples, int audits)
{
    std::printf("%dx%d, error against %d samples, %d audits of each\n", size.width, size.height,
                2 * long_samples, audits);
    for (const Kind& kind : kinds) {
        const Subject subject = subject_of(kind, size);
        const TrueError truth = true_error(subject, long_samples);
        std::printf("| %s | %zu | %.2f %% |", name_of(kind).c_str(), truth.covered,
                    100.0 * truth.relative_rmse());
        const Row row = row_of(subject, truth, audits);
        std::printf(" %.1f %% (%.1f, %.1f) | %.2f | %+.1f %% |\n", 100.0 * row.held, 100.0 * row.below,
                    100.0 * row.above, row.width, 100.0 * row.bias);
        std::fflush(stdout);
    }
}

} // namespace
} // namespace lambent::audit::testing

int main(int count, char** words)
{
    const auto number = [&](int i, int usual) { return i < count ? std::atoi(words[i]) : usual; };
    lambent::audit::testing::print({number(1, 160), number(2, 90)}, number(3, 2048), number(4, 200));
}
