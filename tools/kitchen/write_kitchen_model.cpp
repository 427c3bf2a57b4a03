// write_kitchen_model OUT.glb
// Writes the room of the environment `kitchen` as a glTF file.
#include "kitchen/glb.h"
#include "base/file.h"
#include "kitchen/model/kitchen.h"

#include <cstdio>
#include <exception>

int main(int count, char** words)
{
    if (count != 2) {
        std::fprintf(stderr, "usage: write_kitchen_model OUT.glb\n");
        return 2;
    }
    try {
        lambent::write_file(words[1], lambent::encode_glb(lambent::kitchen::make_kitchen()));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_kitchen_model: error: %s\n", error.what());
        return 1;
    }
}
