// Text as HTML.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace lambent::report {

/// Escapes text for use between tags and in quoted attributes.
std::string escape(std::string_view text);

/// A file's name as a relative URL. No name makes it a URL with a scheme or a host.
std::string address(std::string_view file);

/// ` name="value"`, escaped.
std::string attribute(std::string_view name, std::string_view value);

/// `<tag>text</tag>`, the text escaped. `tag` may include attributes.
std::string element(std::string_view tag, std::string_view text);

/// The same for prose: options such as --size become code that is not broken across lines, as browsers do after
/// hyphens.
std::string prose(std::string_view tag, std::string_view text);

/// A number in the syntax of CSS and SVG, rounded to hundredths.
std::string decimal(double value);

/// Unique ids for the parts of a page.
class Ids {
public:
    /// `wanted`, with invalid characters replaced and a number appended if the id is taken.
    std::string take(std::string_view wanted);

private:
    std::set<std::string> taken_;
};

} // namespace lambent::report
