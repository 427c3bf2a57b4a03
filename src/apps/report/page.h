// A page of figures as one HTML file that needs neither network nor script to be read. Pictures are files beside it.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace lambent::report {

/// A measured number, shown under its picture.
struct Number {
    std::string name, value; ///< as shown: "relative error", "1.3 %"
};

struct PagePicture {
    std::string file; ///< relative to the page
    int width = 0, height = 0;
    std::string title;                 ///< a few words: "e = 700"
    std::string alt;                   ///< describes the picture
    std::vector<std::string> commands; ///< make the file, in order; as typed
    std::vector<Number> numbers;
};

/// Pictures side by side, in boxes of one size.
struct Gallery {
    std::vector<PagePicture> pictures;
};

/// Pictures in a table, row by row. Their number is that of rows times that of columns.
struct Matrix {
    std::vector<std::string> rows, columns; ///< titles
    std::vector<PagePicture> pictures;
};

/// Two or more pictures of one size. Any two can be laid over each other, divided by a slider.
struct Comparison {
    std::vector<PagePicture> pictures;
};

struct Table {
    std::vector<std::string> columns; ///< titles; the first column's cells are titles of their rows
    std::vector<std::vector<std::string>> rows;
};

struct Curve {
    std::string name;
    std::vector<double> x, y; ///< above 0
};

/// Curves on logarithmic axes.
struct Plot {
    std::string x_title, y_title;
    std::string alt;
    std::vector<Curve> curves;
};

using FigureBody = std::variant<Gallery, Matrix, Comparison, Table, Plot>;

struct Figure {
    std::string id; ///< in lower case with dashes
    std::string title;
    std::string caption; ///< plain text
    FigureBody content;
};

struct Section {
    std::string id, title;
    std::vector<std::string> text; ///< paragraphs of plain text
    std::vector<Figure> figures;
};

struct Page {
    std::string title, lead;
    PagePicture cover;
    std::vector<Section> sections;
    std::vector<Number> facts; ///< how the page was made; shown at its end
};

/// The whole index.html, UTF-8. Every text in it is escaped.
std::string to_html(const Page& page);

/// The page as JSON, for programs: sections, figures, pictures with their commands and numbers, tables and curves.
std::string to_json(const Page& page);

} // namespace lambent::report
