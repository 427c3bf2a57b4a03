// A glTF file that is parsed but not yet interpreted: its JSON as structs, and the bytes of its buffers.
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
    std::span<const std::uint8_t> bytes; ///< byteLength of them, or fewer if not all are there
    bool present = false; ///< false: not readable, or neither a uri nor a BIN chunk (an error only if used)
};

struct Document {
    std::string file;
    UriBase base;
    gltf::Model model;
    std::string first_loss;           ///< message of the first fault that may have cost geometry; empty: none
    std::vector<BufferBytes> buffers; ///< of each buffer of the model
    std::vector<std::filesystem::path> beside;      ///< all files that it names, used or not, existing or not
    std::vector<std::vector<std::uint8_t>> storage; ///< bytes of `buffers` that are not in the source

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

/// Parses the file. `source.bytes` must outlive the document. Elements that do not fit the schema and buffers that
/// cannot be read are left out with a warning; a buffer shorter than declared is used as far as it goes, with a
/// warning. Throws Error(bad_input) for files that are not glTF 2.0, and for hostile sizes.
Document open_document(const GltfSource& source, Warnings& warnings);

/// The bytes of a bufferView. Throws Error(bad_input), in which `what` ("accessor 3") names the user of the view.
std::span<const std::uint8_t> view_bytes(const Document& document, int buffer_view, const std::string& what);

/// The bytes of a file named by a uri beside the glTF; the error starts with `where`.
std::vector<std::uint8_t> read_beside(const UriBase& base, const std::string& uri, const std::string& where);

} // namespace lambent::scene
