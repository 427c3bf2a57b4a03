// tinygltf's code, and the one call into it.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // with TINYGLTF_NO_FS tinygltf leaves it out, but its (unused) writer needs it
#include "scene/gltf_document/tinygltf_header.h"

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf_document/gltf_message.h"

#include <limits>

namespace lambent::scene {

tinygltf::Model parse_model(const std::string& json, const std::string& file)
{
    if (json.size() > std::numeric_limits<unsigned int>::max())
        refuse(file, ": JSON: ", json.size(), " bytes is too much");
    tinygltf::Model model;
    std::string error;
    std::string warning;
    bool parsed = false;
    try {
        tinygltf::TinyGLTF parser;
        parsed = parser.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                            static_cast<unsigned int>(json.size()), "", tinygltf::NO_REQUIRE);
    } catch (const std::exception& exception) {
        refuse(file, ": ", printable(exception.what()));
    }
    // It returns true, with complaints, after leaving out what it could not read: a silent loss, if believed.
    if (!parsed || !error.empty())
        refuse(file, ": ", printable(std::string_view(error).substr(0, error.find('\n'))));
    return model;
}

} // namespace lambent::scene
