#include "image/radiance/radiance_header.h"

#include "image/refuse.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace lambent::image {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view line)
{
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

// Removes the first word from `rest` and returns it.
std::string_view take_word(std::string_view& rest)
{
    rest = trimmed(rest);
    const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end);
    return word;
}

// The number that the whole word spells, if it does.
template <class Number>
std::optional<Number> parse_number(std::string_view word)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return number;
}

class HeaderReader {
public:
    HeaderReader(std::span<const std::uint8_t> bytes, const std::string& name)
        : text_(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), max_radiance_header)),
          name_(name)
    {
    }

    RadianceHeader read()
    {
        if (!take_line().starts_with("#?"))
            refuse(name_, "not a Radiance picture");
        for (std::string_view line = take_line(); !trimmed(line).empty(); line = take_line())
            read_line(line);
        read_resolution(take_line());
        header_.length = at_;
        for (std::size_t c = 0; c < 3; ++c)
            header_.scale[c] = static_cast<float>(1.0 / exposure_[c]);
        return header_;
    }

private:
    std::string_view take_line()
    {
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos)
            refuse(name_,
                   text_.size() == max_radiance_header ? "its header does not end within "
                                                       : "ends in the middle of its header, after ",
                   text_.size(), " bytes");
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        return line;
    }

    void read_line(std::string_view line)
    {
        const std::size_t equals = line.find('=');
        if (line.starts_with('#') || equals == std::string_view::npos)
            return;
        const std::string_view key = line.substr(0, equals);
        if (key == "FORMAT")
            check_format(trimmed(line.substr(equals + 1)));
        else if (key == "EXPOSURE")
            read_exposure(line, 1);
        else if (key == "COLORCORR")
            read_exposure(line, 3);
    }

    void check_format(std::string_view format) const
    {
        if (format == "32-bit_rle_xyze")
            refuse(name_, "its colours are XYZ (FORMAT=32-bit_rle_xyze), which is not supported; "
                          "ra_xyze -r converts it to RGB");
        if (format != "32-bit_rle_rgbe")
            refuse(name_, "its FORMAT is ", printable(format), " and not 32-bit_rle_rgbe");
    }

    // A line has one factor for all channels or one for each. The factors of all lines multiply: the pixels were stored
    // times their product.
    void read_exposure(std::string_view line, std::size_t factors)
    {
        std::string_view rest = line.substr(line.find('=') + 1);
        std::optional<double> factor;
        for (std::size_t c = 0; c < 3; ++c) {
            if (c < factors)
                factor = parse_number<double>(take_word(rest));
            if (!factor || !(*factor > 0.0))
                refuse(name_, "cannot use the header line ", printable(line));
            exposure_[c] *= *factor;
            // Within these bounds 1 / exposure is a normal float.
            if (!(exposure_[c] > 1e-30 && exposure_[c] < 1e30))
                refuse(name_, "cannot use an exposure of ", exposure_[c]);
        }
        if (!trimmed(rest).empty())
            refuse(name_, "cannot use the header line ", printable(line));
    }

    // The line has two axes, the slower one first, each with a sign, a letter and a length: "-Y 1024 +X 2048".
    void read_resolution(std::string_view line)
    {
        std::string_view rest = line;
        const std::string_view major = take_word(rest);
        const auto scanlines = parse_number<std::int64_t>(take_word(rest));
        const std::string_view minor = take_word(rest);
        const auto length = parse_number<std::int64_t>(take_word(rest));
        const auto is_axis = [](std::string_view word, char letter) {
            return word.size() == 2 && (word[0] == '+' || word[0] == '-') && word[1] == letter;
        };
        const bool rows = is_axis(major, 'Y') && is_axis(minor, 'X');
        const bool columns = is_axis(major, 'X') && is_axis(minor, 'Y');
        if ((!rows && !columns) || !scanlines || !length || !trimmed(rest).empty())
            refuse(name_, "cannot understand the resolution line ", printable(line));
        const std::int64_t width = rows ? *length : *scanlines;
        const std::int64_t height = rows ? *scanlines : *length;
        check_size(name_, width, height);
        header_.width = static_cast<int>(width);
        header_.height = static_cast<int>(height);
        header_.order = {columns, (rows ? minor : major)[0] == '-', (rows ? major : minor)[0] == '+'};
        header_.resolution = trimmed(line);
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    std::array<double, 3> exposure_{1, 1, 1};
    RadianceHeader header_;
};

} // namespace

bool is_radiance(std::span<const std::uint8_t> bytes)
{
    return bytes.size() >= 2 && bytes[0] == '#' && bytes[1] == '?';
}

RadianceHeader read_radiance_header(std::span<const std::uint8_t> bytes, const std::string& name)
{
    return HeaderReader(bytes, name).read();
}

} // namespace lambent::image
