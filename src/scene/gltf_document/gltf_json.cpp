#include "scene/gltf_document/gltf_json.h"

#include "scene/gltf_document/gltf_message.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace lambent::scene {
namespace {

using nlohmann::json;

// A list or object of the document that the parser has entered and not left.
struct Level {
    json* container = nullptr;
    const Shape* shape = nullptr;   // of an object; null: any name is kept
    const Property* list = nullptr; // of a list
};

// The level of a list or object that is the value of a property or, `in_list`, an entry of it; none if the property has
// another kind.
std::optional<Level> level_of(const Property* property, bool in_list, bool is_object)
{
    if (property == nullptr)
        return std::nullopt;
    const Kind kind = property->kind;
    if (!is_object) {
        const bool is_list = kind == Kind::words || kind == Kind::numbers || kind == Kind::indices ||
                             kind == Kind::index_maps || kind == Kind::objects;
        return is_list && !in_list ? std::optional(Level{nullptr, nullptr, property}) : std::nullopt;
    }
    if (kind == (in_list ? Kind::objects : Kind::object))
        return Level{nullptr, property->shape, nullptr};
    return kind == (in_list ? Kind::index_maps : Kind::index_map) ? std::optional(Level{}) : std::nullopt;
}

// Builds the document from the parser's events and skips values that are not kept. (The library's own filter, a
// callback, takes time quadratic in the length of an array of objects.)
class Builder : public nlohmann::json_sax<json> {
public:
    explicit Builder(const Shape& shape)
    {
        root_.kind = Kind::object;
        root_.shape = &shape;
    }

    json take() { return std::move(document_); }
    const std::string& failure() const { return failure_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override;
    bool parse_error(std::size_t, const std::string&, const json::exception& error) override;

private:
    template <class Value>
    bool add(Value&& value);
    json& insert(json value);
    bool open(json container);
    bool close();

    json document_;
    Property root_;                     // the document as the value of a property
    std::vector<Level> open_;           // outermost first
    std::string key_;                   // of the next value in an object
    const Property* property_ = &root_; // of the next value; null: its name is not in the shape
    bool is_wanted_ = true;             // whether the next value is kept
    std::size_t unwanted_ = 0;          // depth within a skipped container, itself included; 0: not in one
    std::string failure_;
};

bool Builder::key(string_t& name)
{
    if (unwanted_ != 0)
        return true;
    const Shape* shape = open_.back().shape;
    property_ = shape ? find_property(*shape, name) : nullptr;
    is_wanted_ = shape == nullptr || property_ != nullptr;
    key_ = std::move(name);
    return true;
}

json& Builder::insert(json value)
{
    if (open_.empty())
        return document_ = std::move(value);
    json& outer = *open_.back().container;
    if (outer.is_array()) {
        auto& list = outer.get_ref<json::array_t&>();
        list.push_back(std::move(value));
        return list.back();
    }
    // The last of several members with one name counts.
    return outer.get_ref<json::object_t&>().insert_or_assign(std::move(key_), std::move(value)).first->second;
}

template <class Value>
bool Builder::add(Value&& value)
{
    if (unwanted_ == 0 && std::exchange(is_wanted_, true))
        insert(std::forward<Value>(value));
    return true;
}

bool Builder::open(json container)
{
    if (unwanted_ != 0 || !std::exchange(is_wanted_, true)) {
        ++unwanted_;
        return true;
    }
    const Property* list = open_.empty() ? nullptr : open_.back().list;
    std::optional<Level> level = level_of(list ? list : property_, list != nullptr, container.is_object());
    if (level) {
        level->container = &insert(std::move(container));
        open_.push_back(*level);
        return true;
    }
    // A member stays an empty container, so that the reader can report its kind; entries of lists and index maps, of
    // which there may be many, become null.
    const bool is_member = list == nullptr && property_ != nullptr;
    insert(is_member ? std::move(container) : json());
    ++unwanted_;
    return true;
}

bool Builder::close()
{
    if (unwanted_ != 0)
        --unwanted_;
    else
        open_.pop_back();
    return true;
}

// "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without the bracket.
std::string reason(const std::exception& error)
{
    const std::string_view all = error.what();
    const std::size_t bracket = all.find("] ");
    return printable(bracket == std::string_view::npos ? all : all.substr(bracket + 2));
}

bool Builder::parse_error(std::size_t, const std::string&, const json::exception& error)
{
    failure_ = reason(error);
    return false;
}

} // namespace

json parse_json(std::string_view text, const Shape& shape, const std::string& file)
{
    // Some exporters pad the GLB chunk with zeros instead of spaces.
    while (text.ends_with('\0'))
        text.remove_suffix(1);
    Builder builder(shape);
    if (!json::sax_parse(text.begin(), text.end(), &builder))
        refuse(file, ": JSON: ", builder.failure());
    json document = builder.take();
    if (!document.is_object())
        refuse(file, ": JSON: the top level is not an object");
    return document;
}

} // namespace lambent::scene
