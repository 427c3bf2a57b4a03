// Text as HTML.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace lambent::report {

/// Text as it may stand between tags and inside an attribute in quotes.
std::string escape(std::string_view text);

/// A file's name as a relative address: whatever it holds, it leads nowhere but to a file.
std::string address(std::string_view file);

/// ` name="value"`, escaped.
std::string attribute(std::string_view name, std::string_view value);

/// `<tag>text</tag>`, the text escaped. `tag` may bring attributes of its own.
std::string element(std::string_view tag, std::string_view text);

/// The same of a sentence, whose options, such as --size, are code that no line breaks: browsers do after hyphens.
std::string prose(std::string_view tag, std::string_view text);

/// A number as CSS and SVG read it, to a hundredth.
std::string decimal(double value);

/// Names for the parts of a page, none given twice.
class Ids {
public:
    /// `wanted` with what an id should not hold replaced, and a number at its end if another has it already.
    std::string take(std::string_view wanted);

private:
    std::set<std::string> taken_;
};

} // namespace lambent::report
