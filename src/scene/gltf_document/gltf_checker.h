// Checks JSON against a schema given as tables, and takes out what does not fit.
#pragma once

#include "scene/gltf_document/gltf_losses.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lambent::scene {

enum class Kind {
    flag,       ///< true or false
    word,       ///< a string
    words,      ///< strings
    number,     ///< one number that fits a float
    numbers,    ///< numbers, `length` of them (0: any number)
    index,      ///< 0 .. 2^31 - 1
    indices,    ///< indices, any number
    index_map,  ///< object of indices
    index_maps, ///< objects of indices
    size,       ///< 0 .. 2^53
    object,     ///< object of `shape`
    objects,    ///< objects of `shape`
};

struct Property;

struct Shape {
    std::span<const Property> properties;
};

enum class Need { optional, required };

struct Property {
    const char* name;
    Kind kind;
    Need need = Need::optional;
    std::size_t length = 0;
    const Shape* shape = nullptr;
    const char* element = nullptr; ///< of objects: what one is called in messages
    std::size_t most = 0;          ///< of objects: how many are read
};

/// The property of this name; null: the shape has none.
const Property* find_property(const Shape& shape, std::string_view name);

/// Who hears of what does not fit.
struct CheckNotes {
    const std::string& file;
    Losses& losses;
};

/// Makes the document fit the shape. Unknown members go. A member that does not fit goes with a warning; where the object
/// needs it, the object goes, up to the next list, whose element becomes a harmless one that bears `broken_mark`
/// (scene/gltf_document/gltf_json.h). Entries of index lists that do not fit become `unreadable_index`.
/// Returns the first loss that may have cost something to draw, as one line, or nothing.
/// Throws Error(bad_input) where the document itself does not fit, for lists longer than theirs may
/// be, and for more than 10 000 elements that do not fit.
std::string check_shape(nlohmann::json& document, const Shape& shape, const CheckNotes& notes);

} // namespace lambent::scene
