// Small valid files for fuzz_gltf to start from: the simplest, and one that uses most of what is read.
#include "tests/scene/rich_file.h"

#include <filesystem>
#include <fstream>

int main(int argc, char** argv)
{
    using namespace lambent::scene::test;
    if (argc != 2)
        return 2;
    const std::filesystem::path folder = argv[1];
    const Bytes seeds[] = {triangle().glb(), triangle().gltf(), rich_file().glb(), rich_file().gltf()};
    std::ofstream list(folder / "list");
    for (std::size_t i = 0; i < std::size(seeds); ++i) {
        const std::filesystem::path path = folder / std::to_string(i);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(seeds[i].data()),
                   static_cast<std::streamsize>(seeds[i].size()));
        list << (i > 0 ? "," : "") << path.string();
    }
    return list.good() ? 0 : 1;
}
