#include "apps/report/figures.h"

#include "apps/report/plot.h"

#include <algorithm>

namespace lambent::report {
namespace {

// Commands, which are shown once, and the titles of the pictures that they make.
struct Recipe {
    std::string id, titles;
    std::vector<std::string> commands;
};

using Recipes = std::vector<Recipe>;

// The title of a picture outside its figure: with the figure's number.
std::string title_of(const PagePicture& picture, const FigureIds& own)
{
    const std::string figure = own.number.empty() ? "Cover" : "Figure " + own.number;
    return picture.title.empty() ? figure : figure + " · " + picture.title;
}

Recipes recipes_of(const std::vector<PagePicture>& pictures, const FigureIds& own)
{
    Recipes recipes;
    for (const PagePicture& picture : pictures) {
        const auto same = std::find_if(recipes.begin(), recipes.end(), [&](const Recipe& recipe) {
            return recipe.commands == picture.commands;
        });
        if (same == recipes.end())
            recipes.push_back({own.ids.take(own.id + "-made"), picture.title, picture.commands});
        else if (!picture.title.empty())
            same->titles += (same->titles.empty() ? "" : ", ") + picture.title;
    }
    return recipes;
}

// Puts each word in an element of its own: browsers break lines after hyphens, which would split options.
std::string words_html(const std::string& command)
{
    std::string html;
    for (std::size_t at = 0; at < command.size();) {
        const std::size_t word = std::min(command.find_first_not_of(' ', at), command.size());
        const std::size_t end = std::min(command.find(' ', word), command.size());
        html += command.substr(at, word - at);
        if (end > word)
            html += element("span", command.substr(word, end - word));
        at = end;
    }
    return html;
}

std::string command_html(const std::string& command)
{
    return "<div class=\"command\"><pre><code>" + words_html(command) +
           "</code></pre><button type=\"button\" class=\"copy\" hidden>Copy</button></div>\n";
}

std::string made_html(const Recipes& recipes)
{
    std::string list;
    for (const Recipe& recipe : recipes) {
        if (recipe.commands.empty())
            continue;
        list += "<div class=\"recipe\"" + attribute("id", recipe.id) + ">\n";
        if (recipes.size() > 1 && !recipe.titles.empty())
            list += element("p class=\"for\"", recipe.titles) + "\n";
        for (const std::string& command : recipe.commands)
            list += command_html(command);
        list += "</div>\n";
    }
    if (list.empty())
        return "";
    return "<details class=\"made\"><summary>How this was made</summary>\n" + list + "</details>\n";
}

// Sizes all boxes of a figure by its first picture: nearly all figures have pictures of one size.
std::string frame_style(const std::vector<PagePicture>& pictures, int columns)
{
    if (pictures.empty())
        return "";
    const int height = std::max(pictures.front().height, 1);
    const int width = std::clamp(pictures.front().width, (height + 1) / 2, 4 * height);
    const std::string least = 2 * width > 3 * height ? "15rem" : "9.5rem";
    return " style=\"--ratio:calc(" + std::to_string(width) + "/" + std::to_string(height) +
           ");--columns:" + std::to_string(columns) + ";--least:" + least +
           ";--width:" + std::to_string(width) + "px\"";
}

std::string image_html(const PagePicture& picture, bool is_cover)
{
    std::string alt = picture.alt.empty() ? picture.title : picture.alt;
    if (alt.empty())
        alt = "Picture";
    return "<img" + attribute("src", address(picture.file)) + attribute("alt", alt) +
           attribute("width", std::to_string(picture.width)) +
           attribute("height", std::to_string(picture.height)) +
           (is_cover ? " fetchpriority=\"high\">" : " loading=\"lazy\" decoding=\"async\">");
}

// The picture as a link to its file; the script opens it in the viewer instead.
std::string view_html(const PagePicture& picture, const FigureIds& own, const Recipes& recipes)
{
    std::string made;
    for (const Recipe& recipe : recipes)
        if (recipe.commands == picture.commands && !picture.commands.empty())
            made = attribute("data-made", recipe.id);
    return "<a class=\"view\"" + attribute("href", address(picture.file)) +
           attribute("data-title", title_of(picture, own)) + made + ">" +
           image_html(picture, own.number.empty()) + "</a>\n";
}

// Chooses the number of columns that leaves the last row full or nearly full.
int columns_for(std::size_t pictures)
{
    if (pictures <= 3)
        return std::max(1, static_cast<int>(pictures));
    if (pictures == 4)
        return 2;
    return pictures % 4 == 0 || pictures % 4 > pictures % 3 ? 4 : 3;
}

std::string list_html(const std::vector<PagePicture>& pictures, const FigureIds& own, const Recipes& recipes)
{
    std::string html =
        "<ul class=\"pictures\" role=\"list\"" + frame_style(pictures, columns_for(pictures.size())) + ">\n";
    for (const PagePicture& picture : pictures) {
        html += "<li class=\"picture\">" + view_html(picture, own, recipes) + "<div class=\"about\">";
        if (!picture.title.empty())
            html += element("p class=\"title\"", picture.title);
        html += numbers_html(picture.numbers) + "</div></li>\n";
    }
    return html + "</ul>\n";
}

// The visible part of a figure, and the collapsed part under its caption.
struct FigureHtml {
    std::string shown, folded;
};

FigureHtml html_of(const Gallery& gallery, const FigureIds& own)
{
    const Recipes recipes = recipes_of(gallery.pictures, own);
    return {list_html(gallery.pictures, own, recipes), made_html(recipes)};
}

FigureHtml html_of(const Comparison& comparison, const FigureIds& own)
{
    const Recipes recipes = recipes_of(comparison.pictures, own);
    return {"<div class=\"comparison\"" + frame_style(comparison.pictures, 1) + ">\n" +
                list_html(comparison.pictures, own, recipes) + "</div>\n",
            made_html(recipes)};
}

// Pictures of a matrix without titles get those of their row and column.
std::vector<PagePicture> titled(const Matrix& matrix)
{
    std::vector<PagePicture> pictures = matrix.pictures;
    for (std::size_t i = 0; i < pictures.size() && !matrix.columns.empty(); ++i) {
        const std::size_t row = i / matrix.columns.size();
        if (pictures[i].title.empty() && row < matrix.rows.size())
            pictures[i].title = matrix.rows[row] + ", " + matrix.columns[i % matrix.columns.size()];
    }
    return pictures;
}

std::string matrix_row(const Matrix& matrix, std::size_t row, const FigureIds& own, const Recipes& recipes)
{
    const std::size_t columns = matrix.columns.size();
    std::string html = "<tr><th scope=\"row\"><span>" + escape(matrix.rows[row]) + "</span></th>\n";
    for (std::size_t i = row * columns; i < std::min((row + 1) * columns, matrix.pictures.size()); ++i)
        html += "<td class=\"picture\">" + view_html(matrix.pictures[i], own, recipes) +
                numbers_html(matrix.pictures[i].numbers) + "</td>\n";
    return html + "</tr>\n";
}

FigureHtml html_of(const Matrix& untitled, const FigureIds& own)
{
    const Matrix matrix{untitled.rows, untitled.columns, titled(untitled)};
    const Recipes recipes = recipes_of(matrix.pictures, own);
    const int columns = static_cast<int>(matrix.columns.size());
    std::string html = "<div class=\"scroll\"><table class=\"matrix\"" +
                       frame_style(matrix.pictures, columns) + attribute("aria-labelledby", own.title_id) +
                       ">\n<thead><tr><td></td>";
    for (const std::string& column : matrix.columns)
        html += element("th scope=\"col\"", column);
    html += "</tr></thead>\n<tbody>\n";
    for (std::size_t row = 0; row < matrix.rows.size(); ++row)
        html += matrix_row(matrix, row, own, recipes);
    return {html + "</tbody></table></div>\n", made_html(recipes)};
}

FigureHtml html_of(const Table& table, const FigureIds& own)
{
    return {table_html(table, own.title_id), ""};
}

FigureHtml html_of(const Plot& plot, const FigureIds& own)
{
    return {plot_html(plot), "<details class=\"plotted\"><summary>The numbers of this plot</summary>\n" +
                                 table_html(plotted_numbers(plot), own.title_id) + "</details>\n"};
}

bool is_number_like(const std::string& cell)
{
    const std::size_t digit = cell.find_first_of("0123456789");
    if (digit == std::string::npos)
        return cell.size() <= 3; // empty, or a dash
    return cell.find_first_not_of("+-.<>~ \xe2\x88\x92\xe2\x89\x88") == digit;
}

// Columns of numbers are set with their digits aligned.
bool is_number_column(const Table& table, std::size_t column)
{
    return std::all_of(table.rows.begin(), table.rows.end(), [&](const std::vector<std::string>& row) {
        return column >= row.size() || is_number_like(row[column]);
    });
}

} // namespace

std::string numbers_html(const std::vector<Number>& numbers)
{
    if (numbers.empty())
        return "";
    std::string html = "<dl class=\"numbers\">";
    for (const Number& number : numbers)
        html += "<div>" + element("dt", number.name) + element("dd", number.value) + "</div>";
    return html + "</dl>\n";
}

std::string table_html(const Table& table, const std::string& label)
{
    std::vector<std::string> classes;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        classes.push_back(i > 0 && is_number_column(table, i) ? " class=\"number\"" : "");
    std::string html = "<div class=\"scroll\" role=\"region\" tabindex=\"0\"" +
                       attribute("aria-labelledby", label) + "><table class=\"data\"" +
                       attribute("aria-labelledby", label) + ">\n<thead><tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        html += element("th scope=\"col\"" + classes[i], table.columns[i]);
    html += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
            html += element((i == 0 ? "th scope=\"row\"" : "td") + (i < classes.size() ? classes[i] : ""),
                            row[i]);
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string figure_html(const Figure& figure, const FigureIds& own)
{
    std::string html = "<figure" + attribute("id", own.id) + attribute("aria-labelledby", own.title_id) +
                       ">\n<h3" + attribute("id", own.title_id) + "><span class=\"figure-number\">Figure " +
                       escape(own.number) + "</span> " + escape(figure.title) + "</h3>\n";
    const FigureHtml html_parts =
        std::visit([&](const auto& kind) { return html_of(kind, own); }, figure.content);
    html += html_parts.shown;
    std::string caption = html_parts.folded;
    if (!figure.caption.empty())
        caption = prose("p class=\"caption\"", figure.caption) + "\n" + caption;
    if (!caption.empty())
        html += "<figcaption>" + caption + "</figcaption>\n";
    return html + "</figure>\n";
}

std::string cover_html(const PagePicture& cover, Ids& ids)
{
    const FigureIds own{"cover", "", "", ids};
    const Recipes recipes = recipes_of({cover}, own);
    std::string html = "<figure class=\"cover\">\n" + view_html(cover, own, recipes) + "<figcaption>";
    if (!cover.title.empty())
        html += element("p class=\"title\"", cover.title) + "\n";
    return html + numbers_html(cover.numbers) + made_html(recipes) + "</figcaption></figure>\n";
}

} // namespace lambent::report
