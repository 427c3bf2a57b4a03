#include "apps/report/shot.h"

#include "base/shell.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <span>
#include <string_view>

namespace lambent::report {
namespace {

constexpr std::array<std::string_view, 4> display_options = {"--exposure", "--contrast", "--tone",
                                                             "--dither"};
constexpr std::array<std::string_view, 5> approximation_options = {"--samples", "--ibl", "--mip-level",
                                                                   "--ambient-brightness", "--aa"};

Words without(const Words& words, std::span<const std::string_view> options)
{
    Words left;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (std::find(options.begin(), options.end(), words[i]) == options.end())
            left.push_back(words[i]);
        else if (words[i] != "--dither")
            ++i; // its value too
    }
    return left;
}

template <class Command>
Command parse(const char* command, Words words, const char* output)
{
    words.insert(words.begin(), {"lambent", command});
    words.insert(words.end(), {"-o", output});
    std::vector<const char*> pointers(words.size());
    std::transform(words.begin(), words.end(), pointers.begin(),
                   [](const std::string& word) { return word.c_str(); });
    return std::get<Command>(cli::parse_arguments(static_cast<int>(pointers.size()), pointers.data()));
}

} // namespace

std::string typed(const Words& words)
{
    std::string line;
    for (const std::string& word : words)
        line += text(line.empty() ? "" : " ", shell_quoted(word));
    return line;
}

cli::RenderArguments parse_render(Words words)
{
    return parse<cli::RenderArguments>("render", std::move(words), "picture.png");
}

cli::ReferenceArguments parse_reference(Words words)
{
    return parse<cli::ReferenceArguments>("reference", std::move(words), "picture.png");
}

Words without_display(const Words& words)
{
    // In the report's pipeline these options apply before the light is summed.
    if (std::find(words.begin(), words.end(), "--pipeline") != words.end())
        return words;
    return without(words, display_options);
}

Words without_approximations(const Words& words)
{
    return without(words, approximation_options);
}

std::string rounded(double value, int digits)
{
    if (value == 0.0 || !std::isfinite(value))
        return value == 0.0 ? "0" : "-";
    std::array<char, 400> shown{};
    if (std::fabs(value) < 1e-4) {
        std::snprintf(shown.data(), shown.size(), "%.*g", digits - 1, value);
        return shown.data();
    }
    const int whole = static_cast<int>(std::floor(std::log10(std::fabs(value)))) + 1;
    std::snprintf(shown.data(), shown.size(), "%.*f", std::clamp(digits - whole, 0, 9), value);
    return shown.data();
}

std::string percent(double share)
{
    return text(rounded(100.0 * share, share >= 0.1 ? 3 : 2), " %");
}

std::string noise_text(const std::optional<double>& noise)
{
    return noise ? percent(*noise) : "not known";
}

} // namespace lambent::report
