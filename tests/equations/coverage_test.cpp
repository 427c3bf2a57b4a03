// Every function of the text is called by a probe and names its witness.
#include "tests/equations/probes/probes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace lambent::test {
namespace {

std::string read_without_comments(const std::filesystem::path& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    std::string text;
    for (std::string line; std::getline(file, line);)
        text += line.substr(0, line.find("//")) + '\n';
    return text;
}

bool in_name(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// A name that is followed by a parenthesis: the call or the definition of a function, or a keyword.
struct Call {
    std::string name;
    std::string before; // what stands in its line before it
};

std::vector<Call> calls_in(const std::string& text)
{
    std::vector<Call> calls;
    for (size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1)) {
        size_t begin = at;
        while (begin > 0 && in_name(text[begin - 1]))
            begin--;
        const size_t line = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
        if (begin < at)
            calls.push_back({text.substr(begin, at - begin), text.substr(line, begin - line)});
    }
    return calls;
}

// A definition has nothing before its name but, from the beginning of the line, words and a blank: ONE_BODY or nothing,
// and a type.
bool is_definition(const Call& call)
{
    const auto in_words = [](char c) { return in_name(c) || c == ' '; };
    return call.before.size() > 1 && call.before.back() == ' ' && in_name(call.before.front()) &&
           std::all_of(call.before.begin(), call.before.end(), in_words);
}

// Names of the functions that a text defines, with how many overloads of each.
std::map<std::string, int> defined_functions(const std::string& text)
{
    std::map<std::string, int> overloads;
    for (const Call& call : calls_in(text))
        if (is_definition(call))
            overloads[call.name]++;
    return overloads;
}

// Functions of `text` that `probes` calls less often than they have overloads.
std::vector<std::string> not_called(const std::string& text, const std::string& probes)
{
    std::map<std::string, int> called;
    for (const Call& call : calls_in(probes))
        called[call.name]++;
    std::vector<std::string> missing;
    for (const auto& [name, overloads] : defined_functions(text))
        if (called[name] < overloads)
            missing.push_back(name);
    return missing;
}

// The files that all.glsl includes.
std::vector<std::string> included_files()
{
    const std::string list = read_without_comments(std::filesystem::path(EQUATIONS_FOLDER) / "all.glsl");
    std::vector<std::string> names;
    for (size_t at = list.find('"'); at != std::string::npos; at = list.find('"', at + 1)) {
        const size_t end = list.find('"', at + 1);
        names.push_back(list.substr(at + 1, end - at - 1));
        at = end;
    }
    return names;
}

// The files of shading/ but for those of its passes over fragments: these are held against each other, and against what was
// worked out otherwise, as whole pictures (tests/draw, tests/draw_vulkan).
std::vector<std::filesystem::path> shading_files()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SHADING_FOLDER))
        if (entry.path().extension() == ".glsl" && entry.path().parent_path().filename() != "passes")
            files.push_back(entry.path());
    EXPECT_GE(files.size(), 8u);
    return files;
}

std::string probes_text()
{
    const std::filesystem::path folder = TEST_FOLDER;
    return read_without_comments(folder / "probes.glsl") +
           read_without_comments(folder / "probes_shading.glsl");
}

// Functions of a text that the comment right above names no witness for.
std::vector<std::string> without_witness(const std::string& text)
{
    std::vector<std::string> missing;
    bool witness = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("//")) {
            witness = witness || line.find("Witness:") != std::string::npos ||
                      line.find("Witnesses:") != std::string::npos;
            continue;
        }
        const std::vector<Call> calls = calls_in(line);
        if (!calls.empty() && is_definition(calls.front()) && !witness)
            missing.push_back(calls.front().name);
        witness = false;
    }
    return missing;
}

void expect_witnesses(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << path;
    EXPECT_EQ(without_witness(text.str()), std::vector<std::string>()) << path;
}

TEST(Coverage, EveryFunctionHasAWitness)
{
    for (const std::string& name : included_files())
        expect_witnesses(std::filesystem::path(EQUATIONS_FOLDER) / name);
    for (const std::filesystem::path& file : shading_files())
        expect_witnesses(file);
}

TEST(Coverage, EveryFunctionIsProbed)
{
    std::string text;
    for (const std::string& name : included_files())
        text += read_without_comments(std::filesystem::path(EQUATIONS_FOLDER) / name);
    EXPECT_GE(defined_functions(text).size(), 40u); // the scan sees the text
    EXPECT_EQ(not_called(text, probes_text()), std::vector<std::string>());
}

TEST(Coverage, EveryPassIsProbed)
{
    std::string text;
    for (const std::filesystem::path& file : shading_files())
        text += read_without_comments(file);
    EXPECT_EQ(not_called(text, probes_text()), std::vector<std::string>());
}

TEST(Coverage, EveryProbeIsListed)
{
    const std::string text = probes_text();
    size_t probes = 0;
    for (size_t at = text.find("\nOutputs "); at != std::string::npos; at = text.find("\nOutputs ", at + 1)) {
        const size_t name = at + 9, parenthesis = text.find('(', name);
        if (text.compare(parenthesis, 10, "(Inputs i)") != 0)
            continue;
        probes++;
        EXPECT_TRUE(std::any_of(all_probes().begin(), all_probes().end(), [&](const Probe& p) {
            return p.name == text.substr(name, parenthesis - name);
        })) << text.substr(name, parenthesis - name);
    }
    EXPECT_EQ(probes, all_probes().size());
}

TEST(Coverage, EveryFileIsInTheWholeText)
{
    const std::vector<std::string> included = included_files();
    for (const auto& entry : std::filesystem::directory_iterator(EQUATIONS_FOLDER)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".glsl" && name != "all.glsl" && name != "in_glsl.glsl") {
            EXPECT_EQ(std::count(included.begin(), included.end(), name), 1) << name;
        }
    }
}

TEST(Coverage, ScanFindsWhatIsMissing)
{
    const std::string text = "Real first(Real a)\n{\n    return a;\n}\nvec3 second(vec3 a) { return a; }\n"
                             "ONE_BODY Real second(Real a) { return first(a); }\nstruct Third {\n};\n";
    const std::vector<std::string> none;
    EXPECT_EQ(not_called(text, "x = first(1.0); y = second(x); z = second(y);"), none);
    EXPECT_EQ(not_called(text, "y = second(x); z = second(y);"), std::vector<std::string>({"first"}));
    EXPECT_EQ(not_called(text, "x = first(1.0); y = second(x);"), std::vector<std::string>({"second"}));
    EXPECT_EQ(not_called(text, "x = my_first(1.0); second(second(x))"), std::vector<std::string>({"first"}));
}

TEST(Coverage, ScanFindsWhatHasNoWitness)
{
    const std::string text =
        "// Witness: of the file.\n\n// It is.\n// Witness: two lines.\nReal seen(Real a)\n{\n"
        "    return second(a);\n}\n// None.\nvec3 missed(vec3 a) { return a; }\n"
        "Real bare(\n    Real a)\n{\n}\n// Witness: here.\nvec3 also(vec3 a) { return a; }\n";
    EXPECT_EQ(without_witness(text), std::vector<std::string>({"missed", "bare"}));
}

} // namespace
} // namespace lambent::test
