// Schema tables of JSON: the properties that an object may have, and the member of a struct that each of them fills.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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
    /// A check of the object after it was read, beyond the tables: returns the reason why it is invalid, or an empty
    /// string.
    std::string (*misfit)(const void* object) = nullptr;
};

enum class Need { optional, required };

struct Property {
    std::string_view name;
    Kind kind = Kind::flag;
    Need need = Need::optional;
    std::size_t length = 0;
    const Shape* shape = nullptr;
    const char* element = nullptr; ///< for objects: the name of one in messages
    std::string_view key;          ///< for a material's factors and textures: their key in its maps

    /// Makes `count` values (one, except for lists) in the struct and returns the first one's address; null: the value
    /// is checked and not kept.
    void* (*place)(void* object, const Property&, std::size_t count) = nullptr;
    /// Resets the member of an object that could not be read; null: there is none.
    void (*drop)(void* object, const Property&) = nullptr;
    std::size_t element_bytes = 0;        ///< for objects: the size of the struct of one
    void (*mark_broken)(void*) = nullptr; ///< for objects: resets an unreadable one, and sets is_broken
};

/// The property of this name; null: the shape has none.
inline const Property* find_property(const Shape& shape, std::string_view name)
{
    for (const Property& property : shape.properties)
        if (name == property.name)
            return &property;
    return nullptr;
}

namespace table {

inline constexpr Shape nothing{};

template <class>
struct MemberPointer;
template <class Struct, class Value>
struct MemberPointer<Value Struct::*> {
    using struct_type = Struct;
    using type = Value;
};
template <auto Member>
using MemberType = typename MemberPointer<decltype(Member)>::type;

template <class Value>
struct Plain {
    using type = Value;
    static constexpr bool optional = false;
};
template <class Value>
struct Plain<std::optional<Value>> {
    using type = Value;
    static constexpr bool optional = true;
};

template <class Value>
struct KindOf;
template <>
struct KindOf<bool> : std::integral_constant<Kind, Kind::flag> {
};
template <>
struct KindOf<std::string> : std::integral_constant<Kind, Kind::word> {
};
template <>
struct KindOf<std::vector<std::string>> : std::integral_constant<Kind, Kind::words> {
};
template <>
struct KindOf<double> : std::integral_constant<Kind, Kind::number> {
};
template <std::size_t N>
struct KindOf<std::array<double, N>> : std::integral_constant<Kind, Kind::numbers> {
};
template <>
struct KindOf<std::vector<double>> : std::integral_constant<Kind, Kind::numbers> {
};
template <>
struct KindOf<int> : std::integral_constant<Kind, Kind::index> {
};
template <>
struct KindOf<std::vector<int>> : std::integral_constant<Kind, Kind::indices> {
};
template <>
struct KindOf<std::map<std::string, int>> : std::integral_constant<Kind, Kind::index_map> {
};
template <>
struct KindOf<std::vector<std::map<std::string, int>>> : std::integral_constant<Kind, Kind::index_maps> {
};
template <>
struct KindOf<std::uint64_t> : std::integral_constant<Kind, Kind::size> {
};

template <class Value>
constexpr std::size_t length_of = 0;
template <std::size_t N>
constexpr std::size_t length_of<std::array<double, N>> = N;

template <auto Member>
auto& member(void* object)
{
    return static_cast<typename MemberPointer<decltype(Member)>::struct_type*>(object)->*Member;
}

template <class Value>
void* allocate(Value& value, std::size_t)
{
    return &value;
}
template <class Element>
void* allocate(std::vector<Element>& values, std::size_t count)
{
    values.resize(count);
    return values.data();
}
template <std::size_t N>
void* allocate(std::array<double, N>& values, std::size_t)
{
    return values.data();
}

template <auto Member>
void* place(void* object, const Property&, std::size_t count)
{
    auto& value = member<Member>(object);
    if constexpr (Plain<MemberType<Member>>::optional)
        return allocate(value.emplace(), count);
    else
        return allocate(value, count);
}

template <auto Member>
void drop(void* object, const Property&)
{
    member<Member>(object) = {};
}

template <class Element>
void mark_broken(void* element)
{
    auto& broken = *static_cast<Element*>(element);
    broken = {};
    if constexpr (requires { broken.is_broken; })
        broken.is_broken = true;
}

} // namespace table

/// A row for a member that holds one value, or numbers, strings or indices; the kind follows from its type.
template <auto Member>
constexpr Property value(std::string_view name, Need need = Need::optional, std::size_t length = 0)
{
    using Value = typename table::Plain<table::MemberType<Member>>::type;
    Property row;
    row.name = name;
    row.kind = table::KindOf<Value>::value;
    row.need = need;
    row.length = length != 0 ? length : table::length_of<Value>;
    row.place = table::place<Member>;
    return row;
}

/// A row for a value that is checked and not kept.
constexpr Property unread(std::string_view name, Kind kind, Need need = Need::optional)
{
    Property row;
    row.name = name;
    row.kind = kind;
    row.need = need;
    return row;
}

/// A row for a member that is a struct of its own.
template <auto Member>
constexpr Property nested(std::string_view name, const Shape& shape, Need need = Need::optional)
{
    Property row;
    row.name = name;
    row.kind = Kind::object;
    row.need = need;
    row.shape = &shape;
    row.place = table::place<Member>;
    row.drop = table::drop<Member>;
    return row;
}

/// A row for an object whose values fill members of the enclosing struct. These are not reset if the object cannot be
/// read: a required property of it must be its only one.
constexpr Property inside(std::string_view name, const Shape& shape)
{
    Property row;
    row.name = name;
    row.kind = Kind::object;
    row.shape = &shape;
    row.place = [](void* object, const Property&, std::size_t) { return object; };
    return row;
}

/// A row for a flag that is true if an object is present.
template <auto Member>
constexpr Property presence(std::string_view name)
{
    Property row;
    row.name = name;
    row.kind = Kind::object;
    row.shape = &table::nothing;
    row.place = [](void* object, const Property&, std::size_t) -> void* {
        table::member<Member>(object) = true;
        return object;
    };
    row.drop = table::drop<Member>;
    return row;
}

/// A row for a list of structs.
template <auto Member>
constexpr Property list(std::string_view name, const Shape& shape, const char* element)
{
    using Element = typename table::MemberType<Member>::value_type;
    Property row;
    row.name = name;
    row.kind = Kind::objects;
    row.shape = &shape;
    row.element = element;
    row.place = table::place<Member>;
    row.element_bytes = sizeof(Element);
    row.mark_broken = table::mark_broken<Element>;
    return row;
}

} // namespace lambent::scene
