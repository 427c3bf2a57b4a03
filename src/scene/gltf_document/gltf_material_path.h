// Paths of the rows of shading/material/ in the JSON of a glTF's material.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lambent::scene {

constexpr bool is_extension(std::string_view object)
{
    return object.starts_with("KHR_") || object.starts_with("EXT_");
}

/// The path of a key in one of a material's objects, or in the material itself.
class MaterialPath {
public:
    constexpr MaterialPath(std::string_view object, std::string_view key)
    {
        if (is_extension(object))
            add("extensions/");
        if (object != "material") {
            add(object);
            add("/");
        }
        add(key);
    }

    constexpr std::string_view view() const { return {text_.data(), size_}; }

private:
    constexpr void add(std::string_view more)
    {
        for (const char c : more)
            text_[size_++] = c;
    }

    std::array<char, 96> text_{};
    std::size_t size_ = 0;
};

} // namespace lambent::scene
