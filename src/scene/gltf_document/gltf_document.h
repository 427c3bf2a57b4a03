// A glTF file taken apart but not yet interpreted: tinygltf's model, the buffers' bytes, the images' sources.
#pragma once

#include "scene/gltf_document/gltf_source.h"
#include "scene/gltf_document/gltf_message.h"
#include "scene/gltf_document/gltf_uri.h"
#include "scene/gltf_document/tinygltf_header.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

struct BufferBytes {
    std::span<const std::uint8_t> bytes; ///< exactly byteLength of them
    bool present = false; ///< false: neither a uri nor a BIN chunk (allowed while nothing uses it)
};

/// Where an image's PNG or JPEG bytes are: one of the two, or the image is left out.
struct ImageSource {
    std::string name;
    std::string uri;
    int buffer_view = -1;
    bool is_broken = false; ///< neither, as was told
};

/// An animation as the file lists it. Everything is checked when it is read.
struct AnimationSource {
    struct Channel {
        int sampler = 0;
        int node = -1; ///< -1: none, an extension says what moves
        std::string path;
    };
    struct Sampler {
        int input = 0, output = 0; ///< accessors
        std::string interpolation = "LINEAR";
        bool is_broken = false; ///< as was told
    };
    std::string name;
    std::vector<Channel> channels;
    std::vector<Sampler> samplers;
};

struct Document {
    std::string file;
    UriBase base;
    tinygltf::Model model; ///< without buffers, images and animations; every property checked by check_schema
    std::string first_loss; ///< the first fault that may have cost something to draw; empty: none
    std::vector<BufferBytes> buffers;
    std::vector<ImageSource> images;
    std::vector<AnimationSource> animations;
    std::vector<std::filesystem::path> beside;      ///< the files that it names, wanted or not; there or not
    std::vector<std::vector<std::uint8_t>> storage; ///< what `buffers` point into, unless it is the source

    Document() = default;
    Document(Document&&) = default; // a copy's `buffers` would point into the original
    Document& operator=(Document&&) = default;

    /// Throws Error(bad_input): the file's name, then the arguments.
    template <class... Parts>
    [[noreturn]] void fail(const Parts&... parts) const
    {
        refuse(file, ": ", parts...);
    }

    std::uint64_t buffer_bytes() const; ///< all buffers together
};

/// Takes the file apart. `source.bytes` must outlive the document. What does not fit the schema is left out with a warning,
/// and so is a buffer that cannot be read; where one is shorter than it says, what is there is used.
/// Throws Error(bad_input) for what is no glTF 2.0, and for hostile sizes.
Document open_document(const GltfSource& source, Warnings& warnings);

/// The bytes of a bufferView; `what` ("accessor 3") says in the error who asked. Throws Error(bad_input).
std::span<const std::uint8_t> view_bytes(const Document& document, int buffer_view, const std::string& what);

/// Whether an element stands for one that could not be read, as was told.
bool is_broken(const tinygltf::ExtensionMap& extensions);

/// The bytes of a file named by a uri beside the glTF; the error starts with `where`.
std::vector<std::uint8_t> read_beside(const UriBase& base, const std::string& uri, const std::string& where);

/// tinygltf's parse of JSON text that passed check_schema.
tinygltf::Model parse_model(const std::string& json, const std::string& file);

} // namespace lambent::scene
