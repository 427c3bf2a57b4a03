#include "scene/gltf_document/gltf_reader.h"

#include "scene/gltf_document/gltf_message.h"
#include "scene/gltf_document/gltf_model.h"
#include "scene/gltf_document/gltf_number.h"
#include "scene/gltf_document/document_position.h"

#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace lambent::scene {
namespace {

using nlohmann::json;

constexpr double most_index = gltf::unreadable_index;
constexpr double most_size = 9007199254740992.0;

// A file with more broken elements than this is refused.
constexpr std::size_t most_broken = 10'000;

// A message without the file's name; empty: no fault.
using Fault = std::string;

class Reader {
public:
    explicit Reader(const ReadNotes& notes) : notes_(notes), bytes_left_(notes.most_bytes) {}

    Fault read_object(json& source, const Shape& shape, const DocumentPosition& position, void* object);
    std::string first_loss() { return std::move(first_loss_); }

private:
    // A value of the document, its property, and the struct that it is read into.
    struct Value {
        json& source;
        const Property& property;
        void* object;

        template <class Type>
        Type* allocate(std::size_t count = 1) const
        {
            return property.place ? static_cast<Type*>(property.place(object, property, count)) : nullptr;
        }
        template <class Type>
        void keep(Type&& value) const
        {
            if (auto* kept = allocate<std::remove_cvref_t<Type>>())
                *kept = std::forward<Type>(value);
        }
    };

    void lose(const Fault& fault, const char* cost, const DocumentPosition& position);
    Fault read_value(const Value& value, const DocumentPosition& position);
    Fault read_one(const Value& value, const DocumentPosition& position);
    Fault read_list(const Value& value, const DocumentPosition& position);
    Fault read_words(const Value& value, const DocumentPosition& position);
    Fault read_nested(const Value& value, const DocumentPosition& position);
    Fault read_objects(const Value& value, const DocumentPosition& position);
    void read_indices(const Value& value, const DocumentPosition& position);
    void read_index_map(const json& source, const DocumentPosition& position, gltf::AttributeMap* map);
    void read_index_maps(const Value& value, const DocumentPosition& position);
    void spend(std::size_t elements, std::size_t bytes);

    ReadNotes notes_;
    std::string first_loss_;
    std::uint64_t bytes_left_;
    std::size_t broken_ = 0;
};

void Reader::lose(const Fault& fault, const char* cost, const DocumentPosition& position)
{
    const std::string line = text(notes_.file, ": ", fault);
    notes_.losses.add(line, cost);
    if (first_loss_.empty() && holds_geometry(position))
        first_loss_ = line;
}

Fault Reader::read_object(json& source, const Shape& shape, const DocumentPosition& position, void* object)
{
    if (!source.is_object())
        return fault_at(position, "not an object");
    std::vector<Fault> ignored;
    for (auto member = source.begin(); member != source.end(); ++member) {
        const Property* property = find_property(shape, member.key());
        if (property == nullptr)
            continue;
        Fault fault = read_value({member.value(), *property, object}, position);
        if (fault.empty())
            continue;
        if (property->need == Need::required)
            return fault;
        ignored.push_back(std::move(fault));
    }
    for (const Property& property : shape.properties)
        if (property.need == Need::required && !source.contains(property.name))
            return fault_at(position, text(property.name, " is missing"));
    if (const std::string reason = shape.misfit ? shape.misfit(object) : ""; !reason.empty())
        return ignored.empty() ? fault_at(position, reason) : ignored.front();
    for (const Fault& fault : ignored)
        lose(fault, "ignored", position);
    return {};
}

Fault Reader::read_nested(const Value& value, const DocumentPosition& position)
{
    const Property& property = value.property;
    const DocumentPosition inner{&position, property.name, -1};
    Fault fault = read_object(value.source, *property.shape, inner, value.allocate<void>());
    if (!fault.empty() && property.drop)
        property.drop(value.object, property);
    return fault;
}

// Counts elements of a list against the limit of memory, before they are made.
void Reader::spend(std::size_t elements, std::size_t bytes)
{
    if (elements > bytes_left_ / bytes)
        refuse(notes_.file, ": JSON: more elements than a file of its size may have");
    bytes_left_ -= elements * bytes;
}

Fault Reader::read_objects(const Value& value, const DocumentPosition& position)
{
    const Property& property = value.property;
    const std::size_t count = value.source.size();
    spend(count, property.element_bytes);
    auto* elements = value.allocate<std::byte>(count);
    for (std::size_t i = 0; i < count; ++i) {
        json& source = value.source[i];
        void* element = elements + i * property.element_bytes;
        const DocumentPosition inner{&position, property.element, static_cast<std::ptrdiff_t>(i)};
        if (const Fault fault = read_object(source, *property.shape, inner, element); !fault.empty()) {
            lose(fault, "left out", inner);
            if (++broken_ > most_broken)
                refuse(notes_.file, ": ", fault, " (and more than ", most_broken, " elements are broken)");
            property.mark_broken(element);
        }
        source = nullptr; // frees its memory
    }
    return {};
}

void Reader::read_indices(const Value& value, const DocumentPosition& position)
{
    bool told = false;
    int* index = value.allocate<int>(value.source.size());
    for (const json& source : value.source) {
        std::uint64_t whole = gltf::unreadable_index;
        const std::string reason = read_whole(source, most_index, value.property.name, whole);
        if (!reason.empty() && !std::exchange(told, true))
            lose(fault_at(position, reason), "ignored", position);
        *index++ = static_cast<int>(whole);
    }
}

void Reader::read_index_map(const json& source, const DocumentPosition& position, gltf::AttributeMap* map)
{
    bool told = false;
    for (auto member = source.begin(); member != source.end(); ++member) {
        std::uint64_t index = 0;
        const std::string reason = read_whole(member.value(), most_index, printable(member.key()), index);
        if (reason.empty())
            map->emplace(member.key(), static_cast<int>(index));
        else if (!std::exchange(told, true))
            lose(fault_at(position, reason), "ignored", position);
    }
}

void Reader::read_index_maps(const Value& value, const DocumentPosition& position)
{
    auto* map = value.allocate<gltf::AttributeMap>(value.source.size());
    for (const json& source : value.source) {
        if (source.is_object())
            read_index_map(source, position, map);
        ++map;
    }
}

Fault Reader::read_words(const Value& value, const DocumentPosition& position)
{
    for (const json& word : value.source)
        if (!word.is_string())
            return fault_at(position, text(value.property.name, " has an entry that is not a string"));
    auto* words = value.allocate<std::string>(value.source.size());
    for (json& word : value.source)
        *words++ = std::move(word.get_ref<std::string&>());
    return {};
}

Fault Reader::read_list(const Value& value, const DocumentPosition& position)
{
    const Property& property = value.property;
    if (!value.source.is_array())
        return fault_at(position, text(property.name, " is not an array"));
    switch (property.kind) {
    case Kind::objects:
        return read_objects(value, position);
    case Kind::words:
        return read_words(value, position);
    case Kind::indices:
        read_indices(value, position);
        return {};
    case Kind::index_maps:
        read_index_maps(value, position);
        return {};
    default:
        break;
    }
    if (const std::string reason = check_numbers(value.source, property); !reason.empty())
        return fault_at(position, reason);
    auto* numbers = value.allocate<double>(value.source.size());
    for (const json& number : value.source)
        *numbers++ = number.get<double>();
    return {};
}

// Reads a value that is neither an object nor a list.
Fault Reader::read_one(const Value& value, const DocumentPosition& position)
{
    const auto& [source, property, object] = value;
    std::string reason;
    std::uint64_t whole = 0;
    switch (property.kind) {
    case Kind::flag:
        if (source.is_boolean())
            value.keep(source.get<bool>());
        else
            reason = text(property.name, " is not true or false");
        break;
    case Kind::word:
        if (source.is_string())
            value.keep(std::move(source.get_ref<std::string&>()));
        else
            reason = text(property.name, " is not a string");
        break;
    case Kind::number:
        if (reason = check_number(source, property.name); reason.empty())
            value.keep(source.get<double>());
        break;
    case Kind::index:
        if (reason = read_whole(source, most_index, property.name, whole); reason.empty())
            value.keep(static_cast<int>(whole));
        break;
    default:
        if (reason = read_whole(source, most_size, property.name, whole); reason.empty())
            value.keep(whole);
    }
    return reason.empty() ? Fault() : fault_at(position, reason);
}

Fault Reader::read_value(const Value& value, const DocumentPosition& position)
{
    switch (value.property.kind) {
    case Kind::flag:
    case Kind::word:
    case Kind::number:
    case Kind::index:
    case Kind::size:
        return read_one(value, position);
    case Kind::object:
        return read_nested(value, position);
    case Kind::index_map:
        if (!value.source.is_object())
            return fault_at(position, text(value.property.name, " is not an object"));
        read_index_map(value.source, position, value.allocate<gltf::AttributeMap>());
        return {};
    default:
        return read_list(value, position);
    }
}

} // namespace

std::string read_document(json& document, const Shape& shape, void* object, const ReadNotes& notes)
{
    Reader reader(notes);
    if (const Fault fault = reader.read_object(document, shape, {}, object); !fault.empty())
        refuse(notes.file, ": ", fault);
    return reader.first_loss();
}

} // namespace lambent::scene
