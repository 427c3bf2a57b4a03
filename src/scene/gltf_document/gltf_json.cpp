#include "scene/gltf_document/gltf_json.h"

#include "scene/gltf_document/gltf_message.h"

#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace lambent::scene {
namespace {

using nlohmann::json;

constexpr int deepest = 64;
constexpr std::size_t most_values = 4'000'000;

// Both parsers that follow are safe at this depth; neither limits it by itself.
void check_size(std::string_view text, const std::string& file)
{
    int depth = 0;
    std::size_t values = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
        case '"':
            for (++i; i < text.size() && text[i] != '"'; ++i)
                i += text[i] == '\\';
            break;
        case '{':
        case '[':
            if (++depth > deepest)
                refuse(file, ": JSON: byte ", i, ": nested more than ", deepest, " deep");
            [[fallthrough]];
        case ',':
            ++values;
            break;
        case '}':
        case ']':
            --depth;
            break;
        default:
            break;
        }
    }
    if (values > most_values)
        refuse(file, ": JSON: more than ", most_values, " values");
}

// Builds the document from the parser's events, without the members that are not read. (The library's own way
// to leave members out, a callback, takes time quadratic in the length of an array of objects.)
class Builder : public nlohmann::json_sax<json> {
public:
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
    bool add(json value);
    bool open(json container);
    bool close();

    json document_;
    std::vector<json*> open_;    // containers from the top level inwards
    std::string key_;            // of the next value in an object
    bool is_wanted_ = true;      // whether that value is read
    std::size_t unwanted_ = 0;   // containers entered since one that is not read, itself included
    std::string list_;           // at the top level, being read
    std::size_t list_limit_ = 0; // and how many elements it may have
    std::string failure_;
};

bool Builder::key(string_t& name)
{
    if (unwanted_ != 0)
        return true;
    if (open_.size() == 1) {
        const std::optional<std::size_t> limit = top_level_limit(name);
        is_wanted_ = limit.has_value();
        list_ = name;
        list_limit_ = limit.value_or(0);
    } else {
        is_wanted_ = name != "extras";
    }
    key_ = std::move(name);
    return true;
}

bool Builder::add(json value)
{
    if (unwanted_ != 0 || !std::exchange(is_wanted_, true))
        return true;
    if (open_.size() == 2 && open_.back()->is_array() && open_.back()->size() == list_limit_) {
        failure_ = text("more than ", list_limit_, " ", list_);
        return false;
    }
    if (open_.empty())
        document_ = std::move(value);
    else if (open_.back()->is_array())
        open_.back()->push_back(std::move(value));
    else
        (*open_.back())[key_] = std::move(value);
    return true;
}

bool Builder::open(json container)
{
    if (unwanted_ != 0 || !is_wanted_) {
        is_wanted_ = true;
        ++unwanted_;
        return true;
    }
    if (!add(std::move(container)))
        return false;
    if (open_.empty())
        open_.push_back(&document_);
    else if (open_.back()->is_array())
        open_.push_back(&open_.back()->back());
    else
        open_.push_back(&(*open_.back())[key_]);
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

json parse_gltf_json(std::string_view text, const std::string& file)
{
    check_size(text, file);
    // Some exporters fill the GLB chunk with zeros where spaces belong.
    while (text.ends_with('\0'))
        text.remove_suffix(1);
    Builder builder;
    if (!json::sax_parse(text.begin(), text.end(), &builder))
        refuse(file, ": JSON: ", builder.failure());
    json document = builder.take();
    if (!document.is_object())
        refuse(file, ": JSON: the top level is not an object");
    return document;
}

} // namespace lambent::scene
