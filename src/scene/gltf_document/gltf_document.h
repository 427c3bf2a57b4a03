// A glTF file taken apart but not yet interpreted: what its JSON says, and the buffers' bytes.
#pragma once

#include "scene/gltf_document/gltf_source.h"
#include "scene/gltf_document/gltf_message.h"
#include "scene/gltf_document/gltf_model.h"
#include "scene/gltf_document/gltf_uri.h"

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

struct Document {
    std::string file;
    UriBase base;
    gltf::Model model;
    std::string first_loss;           ///< the first fault that may have cost something to draw; empty: none
    std::vector<BufferBytes> buffers; ///< of each buffer of the model
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

/// The bytes of a file named by a uri beside the glTF; the error starts with `where`.
std::vector<std::uint8_t> read_beside(const UriBase& base, const std::string& uri, const std::string& where);

} // namespace lambent::scene
