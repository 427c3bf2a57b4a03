// Small valid files for fuzz_gltf to start from: the simplest, and one that uses most of what is read.
#include "tests/fuzz/seed_files.h"
#include "tests/scene/rich_file.h"

int main(int argc, char** argv)
{
    using namespace lambent::scene::test;
    if (argc != 2)
        return 2;
    const Bytes seeds[] = {triangle().glb(), triangle().gltf(), rich_file().glb(), rich_file().gltf()};
    return lambent::fuzz::write_seeds(argv[1], seeds);
}
