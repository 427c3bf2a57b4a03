// Any words as a command line: understood or refused with one line; anything else is a crash.
#include "apps/options/arguments.h"
#include "base/error.h"

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // One word a line.
    std::vector<std::string> words = {"lambent"};
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        words.emplace_back(line.substr(0, line.find('\0'))); // no word of a command line goes on behind one
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    std::vector<const char*> pointers;
    pointers.reserve(words.size());
    for (const std::string& word : words)
        pointers.push_back(word.c_str());
    try {
        lambent::cli::parse_arguments(static_cast<int>(pointers.size()), pointers.data());
    } catch (const lambent::Error& error) {
        if (std::string_view(error.what()).empty() || error.failure() != lambent::Failure::usage)
            std::abort();
    }
    return 0;
}
