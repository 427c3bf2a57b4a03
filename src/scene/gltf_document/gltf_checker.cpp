#include "scene/gltf_document/gltf_checker.h"

#include "scene/gltf_document/gltf_json.h"
#include "scene/gltf_document/gltf_message.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace lambent::scene {
namespace {

using nlohmann::json;

constexpr double most_index = unreadable_index;
constexpr double most_size = 9007199254740992.0;

// One costs a kilobyte, and what it stands for two bytes.
constexpr std::size_t most_stand_ins = 10'000;

// Where in the document: a chain of these on the stack, turned into words only for a message.
struct Place {
    const Place* outer = nullptr;
    std::string_view name;
    std::ptrdiff_t index = -1;
};

std::string describe(const Place& place)
{
    std::string words = place.outer ? describe(*place.outer) : std::string();
    if (place.name.empty())
        return words;
    if (!words.empty())
        words += ", ";
    words += place.name;
    return place.index < 0 ? words : text(words, " ", place.index);
}

// Whether what is lost here may be something to draw, and not only how it looks.
bool holds_geometry(const Place& place)
{
    constexpr std::array<std::string_view, 7> lists = {"",         "scene",      "node",  "mesh",
                                                       "accessor", "bufferView", "buffer"};
    const Place* outermost = &place;
    while (outermost->outer != nullptr && !outermost->outer->name.empty())
        outermost = outermost->outer;
    return std::find(lists.begin(), lists.end(), outermost->name) != lists.end();
}

// What stands for an element that does not fit: as much of one as its readers and tinygltf need.
json stand_in(std::string_view element)
{
    json object = json::object();
    if (element == "accessor")
        object = {{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}};
    else if (element == "bufferView")
        object = {{"buffer", 0}, {"byteLength", 0}};
    else if (element == "buffer")
        object = {{"byteLength", 0}};
    else if (element == "camera")
        object = {{"type", "perspective"}, {"perspective", {{"yfov", 0.0}, {"znear", 0.0}}}};
    else if (element == "light")
        object = {{"type", ""}};
    else if (element == "primitive")
        object = {{"attributes", json::object()}};
    else if (element == "skin")
        object = {{"joints", json::array()}};
    object["extensions"][broken_mark] = json::object();
    return object;
}

// What tables do not say of an element, or nothing.
std::string misfit(std::string_view element, const json& object)
{
    if (element == "accessor") {
        constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4",
                                                           "MAT2",   "MAT3", "MAT4"};
        constexpr std::array<int, 6> components = {5120, 5121, 5122, 5123, 5125, 5126};
        const auto& type = object.at("type").get_ref<const std::string&>();
        const auto component = object.at("componentType").get<std::int64_t>();
        if (std::find(types.begin(), types.end(), type) == types.end())
            return text("type \"", printable(type), "\" is not one of glTF");
        if (std::find(components.begin(), components.end(), component) == components.end())
            return text("componentType ", component, " is not one of glTF");
    }
    if (element == "camera") {
        const auto& type = object.at("type").get_ref<const std::string&>();
        if (type != "perspective" && type != "orthographic")
            return text("type \"", printable(type), "\" is not one of glTF");
        if (!object.contains(type))
            return text(type, " is missing");
    }
    return {};
}

// Faults are lines without the file's name; none: all is well.
using Fault = std::string;

class Checker {
public:
    explicit Checker(const CheckNotes& notes) : notes_(notes) {}

    Fault check_object(json& object, const Shape& shape, const Place& place);
    std::string first_loss() { return std::move(first_loss_); }

private:
    void lose(const Fault& fault, const char* cost, const Place& place);
    Fault check_value(json& value, const Property& property, const Place& place);
    Fault check_objects(json& value, const Property& property, const Place& place);
    void mend_indices(json& value, const Property& property, const Place& place);
    void mend_index_map(json& value, const Place& place);

    CheckNotes notes_;
    std::string first_loss_;
    std::size_t stand_ins_ = 0;
};

Fault fault_at(const Place& place, const std::string& reason)
{
    const std::string words = describe(place);
    return text(words, words.empty() ? "" : ": ", reason);
}

void Checker::lose(const Fault& fault, const char* cost, const Place& place)
{
    const std::string line = text(notes_.file, ": ", fault);
    notes_.losses.add(line, cost);
    if (first_loss_.empty() && holds_geometry(place))
        first_loss_ = line;
}

Fault Checker::check_object(json& object, const Shape& shape, const Place& place)
{
    if (!object.is_object())
        return fault_at(place, "not an object");
    std::vector<Fault> ignored;
    for (auto member = object.begin(); member != object.end();) {
        const Property* property = find_property(shape, member.key());
        Fault fault = property ? check_value(member.value(), *property, place) : Fault();
        if (property && fault.empty()) {
            ++member;
            continue;
        }
        if (property && property->need == Need::required)
            return fault;
        if (property)
            ignored.push_back(std::move(fault));
        member = object.erase(member);
    }
    for (const Property& property : shape.properties)
        if (property.need == Need::required && !object.contains(property.name))
            return fault_at(place, text(property.name, " is missing"));
    if (const std::string reason = misfit(place.name, object); !reason.empty())
        return ignored.empty() ? fault_at(place, reason) : ignored.front();
    for (const Fault& fault : ignored)
        lose(fault, "ignored", place);
    return {};
}

// The reason why a value is no whole number from 0 up to `most`; else it becomes one. JSON knows no integers: 3.0 and 3e0
// are 3. [JSON Schema, "integer"]
std::string make_unsigned(json& value, double most, std::string_view name)
{
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (!(number >= 0.0 && number <= most) || number != std::floor(number))
        return text(name, " is not a whole number from 0 to ", static_cast<std::int64_t>(most));
    value = static_cast<std::uint64_t>(number);
    return {};
}

std::string make_number(json& value, std::string_view name)
{
    if (!value.is_number())
        return text(name, " is not a number");
    const double number = value.get<double>();
    if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max())))
        return text(name, " is too large");
    value = number;
    return {};
}

std::string make_numbers(json& value, const Property& property)
{
    for (json& number : value)
        if (std::string reason = make_number(number, property.name); !reason.empty())
            return reason;
    if (property.length != 0 && value.size() != property.length)
        return text(property.name, " has ", value.size(), " numbers, not ", property.length);
    return {};
}

void Checker::mend_indices(json& value, const Property& property, const Place& place)
{
    std::string first;
    for (json& index : value) {
        const std::string reason = make_unsigned(index, most_index, property.name);
        if (reason.empty())
            continue;
        index = static_cast<std::uint64_t>(unreadable_index);
        if (first.empty())
            lose(fault_at(place, first = reason), "ignored", place);
    }
}

void Checker::mend_index_map(json& value, const Place& place)
{
    bool told = false;
    for (auto member = value.begin(); member != value.end();) {
        const std::string reason = make_unsigned(member.value(), most_index, printable(member.key()));
        if (reason.empty()) {
            ++member;
            continue;
        }
        if (!std::exchange(told, true))
            lose(fault_at(place, reason), "ignored", place);
        member = value.erase(member);
    }
}

Fault Checker::check_objects(json& value, const Property& property, const Place& place)
{
    if (value.size() > property.most)
        refuse(notes_.file, ": ", fault_at(place, text("more than ", property.most, " ", property.name)));
    std::ptrdiff_t index = 0;
    for (json& object : value) {
        const Place inner{&place, property.element, index++};
        if (const Fault fault = check_object(object, *property.shape, inner); !fault.empty()) {
            lose(fault, "left out", inner);
            if (++stand_ins_ > most_stand_ins)
                refuse(notes_.file, ": ", fault, " (as are more than ", most_stand_ins, " elements)");
            object = stand_in(property.element);
        }
    }
    return {};
}

Fault Checker::check_value(json& value, const Property& property, const Place& place)
{
    const auto fault = [&](const std::string& reason) {
        return reason.empty() ? Fault() : fault_at(place, reason);
    };
    const auto is_no = [&](const char* what) {
        return fault_at(place, text(property.name, " is not ", what));
    };
    switch (property.kind) {
    case Kind::flag:
        return value.is_boolean() ? Fault() : is_no("true or false");
    case Kind::word:
        return value.is_string() ? Fault() : is_no("a string");
    case Kind::number:
        return fault(make_number(value, property.name));
    case Kind::index:
        return fault(make_unsigned(value, most_index, property.name));
    case Kind::size:
        return fault(make_unsigned(value, most_size, property.name));
    case Kind::object:
        return check_object(value, *property.shape, {&place, property.name, -1});
    case Kind::index_map:
        if (!value.is_object())
            return is_no("an object");
        mend_index_map(value, place);
        return {};
    default:
        break;
    }
    if (!value.is_array())
        return is_no("an array");
    if (property.kind == Kind::numbers)
        return fault(make_numbers(value, property));
    if (property.kind == Kind::indices)
        mend_indices(value, property, place);
    if (property.kind == Kind::words)
        for (const json& word : value)
            if (!word.is_string())
                return fault_at(place, text(property.name, " holds something that is not a string"));
    if (property.kind == Kind::index_maps)
        for (json& map : value) {
            if (!map.is_object())
                map = json::object();
            mend_index_map(map, place);
        }
    return property.kind == Kind::objects ? check_objects(value, property, place) : Fault();
}

} // namespace

const Property* find_property(const Shape& shape, std::string_view name)
{
    for (const Property& property : shape.properties)
        if (name == property.name)
            return &property;
    return nullptr;
}

std::string check_shape(json& document, const Shape& shape, const CheckNotes& notes)
{
    Checker checker(notes);
    if (const Fault fault = checker.check_object(document, shape, {}); !fault.empty())
        refuse(notes.file, ": ", fault);
    return checker.first_loss();
}

} // namespace lambent::scene
