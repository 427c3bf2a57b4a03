// Valid command lines, a word a line, for fuzz_cli to start from, and the words of all options as its dictionary.
#include "apps/options/option.h"
#include "tests/fuzz/seed_files.h"

#include <set>
#include <string_view>

namespace {

void write_dictionary(const std::filesystem::path& path)
{
    using namespace lambent::cli;
    std::set<std::string> words = {"-o", "--help", "--version", "help", "nan", "inf", "1e400", "-1"};
    for (const CommandRow& row : commands())
        words.emplace(row.name);
    for (const OptionList& list : option_lists())
        for (const Option* option : list.options) {
            words.insert(dashed(*option));
            for (const std::string& word : words_in(option->domain.choices))
                words.insert(word);
        }
    std::ofstream file(path);
    for (const std::string& word : words)
        file << '"' << word << "\"\n";
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    write_dictionary(std::filesystem::path(argv[1]) / "dictionary");
    constexpr std::string_view seeds[] = {
        "render\nreport\n-o\na.png\n--size\n64x48\n--camera\n30,20,4\n--fov\n40\n--aa\n4\n--samples\n40",
        "render\nsphere\n-o\na.exr\n--model\nphong\n--alpha\n625\n--kd\n1,0,0\n--ks\n0,0,1\n--mip-"
        "level\nreport",
        "render\nteapot\n-o\na.hdr\n--light\ndirectional:10,20,1,1,1\n--light\npoint:1,2,3,4,5,6\n--"
        "env\nnone",
        "render\nplane\n-o\na.jpg\n--background\nblur:0.5\n--env-rotation\n90\n--exposure\n2\n--contrast\n1."
        "2",
        "render\ngrid\n-o\na.png\n--background\n1,1,1\n--tone\naces\n--space\nnonlinear\n--stats\njson\n--"
        "quiet",
        "render\na.glb\n-o\na.png\n--animation\nwalk\n--moment\n0.5",
        "env\nsky\n-o\nsky.hdr\n--size\n512x256\n--sun\n10,20\n--turbidity\n3",
        "info\na.glb\n--json",
        "bake\nkitchen\n-o\nbaked\n--size\n64\n--error\n0.02\n--format\ndds\n--irradiance\nsh",
        "reference\ngrid\n-o\na.exr\n--bounces\n1\n--noise\n0.02\n--spp\n9\n--seed\n3\n--uniform",
        "compare\na.exr\nb.exr\n-o\nc.png\n--heat\nrelative\n--clamp\n1\n--max-rel\n0.1",
        "report\n-o\nreport\n--env\nsky\n--env-rotation\n90\n--size\n64x36\n--quick",
        "--help",
    };
    return lambent::fuzz::write_seeds(argv[1], seeds);
}
