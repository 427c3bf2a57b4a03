#include "tests/cli/option_manual.h"

#include "apps/options/option.h"
#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace lambent::cli {
namespace {

const std::string head = "| option | default | meaning |\n| --- | --- | --- |\n";

// A word as code, where it is an option or one of the words that the option takes.
std::string marked_word(const Option& option, const std::string& word)
{
    const std::size_t end = word.find_last_not_of(",.;:)");
    const std::size_t begin = word.find_first_not_of('(');
    if (begin == std::string::npos || end == std::string::npos)
        return word;
    const std::string inner = word.substr(begin, end + 1 - begin);
    const std::vector<std::string> known = words_in(option.domain.choices);
    const bool is_code = inner.starts_with("--") || inner.starts_with(".") ||
                         std::find(known.begin(), known.end(), inner) != known.end();
    return is_code ? text(word.substr(0, begin), "`", inner, "`", word.substr(end + 1)) : word;
}

std::string marked(const Option& option, std::string_view words)
{
    std::string all;
    for (const std::string& word : words_in(words))
        all += text(all.empty() ? "" : " ", marked_word(option, word));
    return all;
}

// What the help says, as the middle of a sentence.
std::string meaning_of(const Option& option)
{
    if (!option.manual.empty())
        return std::string(option.manual);
    std::string meaning = marked(option, option.help);
    if (meaning.size() > 1 && std::islower(static_cast<unsigned char>(meaning[1])))
        meaning[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(meaning[0])));
    return meaning;
}

std::string line_of(const Option& option)
{
    std::string word(option.word);
    if (const std::size_t bar = word.find('|'); bar != std::string::npos)
        word.replace(bar, 1, " or ");
    const std::string letter = option.letter != 0 ? text("`-", option.letter, "`, ") : "";
    const std::string usual = option.form == Form::required ? "needed"
                              : option.usually.empty()      ? std::string(option.usual)
                                                            : marked(option, option.usually);
    return text("| ", letter, "`", dashed(option), "`", word.empty() ? "" : " ", word, " | ", usual,
                usual.empty() ? "" : " ", "| ", meaning_of(option), " |\n");
}

// What the manual says of a list's options once: under the first of the commands that take them.
std::string section_of(const OptionList& list)
{
    if (list.commands == command::all)
        return "Everywhere";
    for (const CommandRow& row : commands())
        if ((list.commands & row.bit) != 0)
            return std::string(row.name);
    return {};
}

std::string table_of(const std::string& section)
{
    std::string needed, others;
    for (const OptionList& list : option_lists())
        if (section_of(list) == section)
            for (const Option* option : list.options)
                if (option->form != Form::positional)
                    (option->form == Form::required ? needed : others) += line_of(*option);
    if (section == "Everywhere")
        others += "| `-h`, `--help` | | the options of a command, as `lambent help COMMAND` |\n";
    return needed + others;
}

} // namespace

std::string with_option_tables(const std::string& page)
{
    std::string made, section;
    for (std::size_t at = 0; at < page.size();) {
        if (page.compare(at, head.size(), head) == 0 && !section.empty()) {
            made += head + table_of(section);
            section.clear();
            at += head.size();
            while (at < page.size() && page[at] == '|')
                at = std::min(page.find('\n', at), page.size() - 1) + 1;
            continue;
        }
        const std::string line = page.substr(at, std::min(page.find('\n', at), page.size() - 1) + 1 - at);
        if (line.starts_with("## "))
            section = line.substr(3, line.size() - 4);
        made += line;
        at += line.size();
    }
    return made;
}

} // namespace lambent::cli
