// The options of a command line, as given.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::cli {

/// The words given, by the names of options without dashes. A flag's word is "yes".
class Given {
public:
    void add(std::string_view name, const std::string& word) { words_[std::string(name)].push_back(word); }

    bool operator()(std::string_view name) const { return words_.contains(name); }

    /// All words of an option, in order; none if it was not given.
    const std::vector<std::string>& words(std::string_view name) const
    {
        static const std::vector<std::string> nothing;
        const auto found = words_.find(name);
        return found == words_.end() ? nothing : found->second;
    }

private:
    std::map<std::string, std::vector<std::string>, std::less<>> words_;
};

} // namespace lambent::cli
