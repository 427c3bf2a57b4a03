#include "apps/report/plot.h"

#include "apps/report/html.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace lambent::report {
namespace {

constexpr std::size_t colours = 6, dashes = 5;

// The size of a drawing and the positions of its axes, in SVG units.
struct Layout {
    const char* name;
    double width, height, left, top, right, bottom;
    int x_room, y_room; // most ticks with labels
};

constexpr Layout wide{"wide", 820, 440, 78, 14, 806, 384, 12, 9};
constexpr Layout narrow{"narrow", 360, 330, 58, 10, 352, 280, 6, 8};

struct Axes {
    LogAxis x, y;
    const Layout& layout;

    double at_x(double value) const { return std::lerp(layout.left, layout.right, x.position(value)); }
    double at_y(double value) const { return std::lerp(layout.bottom, layout.top, y.position(value)); }
};

bool can_show(double value)
{
    return std::isfinite(value) && value > 0;
}

// The largest of 1, 2 or 5 times a power of ten that is not above `value`.
double step_below(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {10.0, 5.0, 2.0})
        if (step * decade <= value * (1 + 1e-9))
            return step * decade;
    return decade;
}

double step_above(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= value * (1 - 1e-9))
            return step * decade;
    return 10 * decade;
}

std::string superscript(int number)
{
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(number))
        text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return text;
}

// 20 as "20", 2e-7 as "2·10⁻⁷".
std::string tick_label(int step, int decade)
{
    if (decade >= -3 && decade <= 3) {
        char text[16];
        std::snprintf(text, sizeof text, "%.*f", std::max(0, -decade), step * std::pow(10.0, decade));
        return text;
    }
    return (step == 1 ? "" : std::to_string(step) + "·") + "10" + superscript(decade);
}

std::string number_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string line(double x1, double y1, double x2, double y2)
{
    return attribute("x1", decimal(x1)) + attribute("y1", decimal(y1)) + attribute("x2", decimal(x2)) +
           attribute("y2", decimal(y2));
}

std::string text(const char* kind, double x, double y, const std::string& words)
{
    return "<text" + attribute("class", kind) + attribute("x", decimal(x)) + attribute("y", decimal(y)) +
           ">" + escape(words) + "</text>\n";
}

std::string grid(const Axes& axes)
{
    const Layout& box = axes.layout;
    std::string html;
    for (const Tick& tick : ticks_of(axes.x, box.x_room)) {
        const double x = axes.at_x(tick.value);
        html += "<line" + attribute("class", tick.is_decade ? "grid decade" : "grid") +
                line(x, box.top, x, box.bottom) + "/>\n";
        if (!tick.label.empty())
            html += text("tick x", x, box.bottom + 20, tick.label);
    }
    for (const Tick& tick : ticks_of(axes.y, box.y_room)) {
        const double y = axes.at_y(tick.value);
        html += "<line" + attribute("class", tick.is_decade ? "grid decade" : "grid") +
                line(box.left, y, box.right, y) + "/>\n";
        if (!tick.label.empty())
            html += text("tick y", box.left - 9, y + 4.5, tick.label);
    }
    return html;
}

std::string titles(const Plot& plot, const Layout& box)
{
    const double middle = (box.top + box.bottom) / 2;
    return text("axis", (box.left + box.right) / 2, box.height - 10, plot.x_title) +
           "<text class=\"axis\" transform=\"translate(14 " + decimal(middle) + ") rotate(-90)\">" +
           escape(plot.y_title) + "</text>\n";
}

// Six markers of about the same area, centred at the origin.
std::string marker_path(std::size_t index)
{
    static constexpr std::array<const char*, colours> paths{
        "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z",
        "M-3.6 -3.6h7.2v7.2h-7.2z",
        "M0 -4.8L4.6 3.4H-4.6z",
        "M0 -5.2L5.2 0L0 5.2L-5.2 0z",
        "M0 4.8L4.6 -3.4H-4.6z",
        "M-1.5 -4.5h3v3h3v3h-3v3h-3v-3h-3v-3h3z",
    };
    return paths[index % paths.size()];
}

std::string curve_class(std::size_t index)
{
    return " class=\"curve colour-" + std::to_string(index % colours) + " dash-" +
           std::to_string(index % dashes) + "\"";
}

std::size_t points_of(const Curve& curve)
{
    return std::min(curve.x.size(), curve.y.size());
}

// Lines between neighbouring points that can be shown, and on each a marker titled with its numbers.
std::string curve_html(const Curve& curve, std::size_t index, const Axes& axes)
{
    std::string lines, markers, points;
    const auto end_line = [&] {
        if (!points.empty())
            lines += "<polyline" + attribute("points", points) + "/>\n";
        points.clear();
    };
    for (std::size_t i = 0; i < points_of(curve); ++i) {
        if (!can_show(curve.x[i]) || !can_show(curve.y[i])) {
            end_line();
            continue;
        }
        const std::string x = decimal(axes.at_x(curve.x[i])), y = decimal(axes.at_y(curve.y[i]));
        const std::string numbers = number_text(curve.x[i]) + ", " + number_text(curve.y[i]);
        points += lambent::text(points.empty() ? "" : " ", x, ",", y);
        markers +=
            lambent::text("<path d=\"", marker_path(index), "\" transform=\"translate(", x, " ", y, ")\">",
                          element("title", lambent::text(curve.name, ": ", numbers)), "</path>\n");
    }
    end_line();
    return "<g" + curve_class(index) + ">\n" + lines + markers + "</g>\n";
}

std::string drawing(const Plot& plot, const Axes& axes)
{
    const Layout& box = axes.layout;
    std::string html = "<svg class=\"plot " + std::string(box.name) + "\" role=\"img\"" +
                       attribute("aria-label", plot.alt.empty() ? plot.y_title : plot.alt) +
                       " viewBox=\"0 0 " + decimal(box.width) + " " + decimal(box.height) + "\">\n" +
                       grid(axes) + titles(plot, box);
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        html += curve_html(plot.curves[i], i, axes);
    return html + "</svg>\n";
}

std::string legend(const Plot& plot)
{
    std::string html = "<ul class=\"legend\" role=\"list\">\n";
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        html += "<li><svg viewBox=\"0 0 44 14\" width=\"44\" height=\"14\" aria-hidden=\"true\"><g" +
                curve_class(i) + "><polyline points=\"1,7 43,7\"/><path d=\"" + marker_path(i) +
                "\" transform=\"translate(22 7)\"/></g></svg>" + element("span", plot.curves[i].name) +
                "</li>\n";
    return html + "</ul>\n";
}

} // namespace

double LogAxis::position(double value) const
{
    return std::log(value / least) / std::log(most / least);
}

LogAxis axis_of(const std::vector<double>& values)
{
    double least = HUGE_VAL, most = 0;
    for (const double value : values)
        if (can_show(value)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    if (most == 0)
        return {};
    LogAxis axis{step_below(least), step_above(most)};
    if (!(axis.most > axis.least)) // all values are one, and it is round
        axis = {axis.least / 2, axis.most * 2};
    return axis;
}

std::vector<Tick> ticks_of(const LogAxis& axis, int room)
{
    const double decades = std::log10(axis.most / axis.least);
    const int every = std::max(1, static_cast<int>(std::ceil(decades / room)));
    const bool name_steps = decades * 3 <= room, have_lines = decades * 4 <= 2.5 * room;
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(std::log10(axis.least) + 1e-9));
    const int last = static_cast<int>(std::ceil(std::log10(axis.most) - 1e-9));
    for (int decade = first; decade <= last; ++decade)
        for (int step = 1; step <= 9; ++step) {
            const double value = step * std::pow(10.0, decade), position = axis.position(value);
            if (position < -1e-9 || position > 1 + 1e-9 || (step > 1 && !have_lines))
                continue;
            const bool is_named = step == 1 ? decade % every == 0 : name_steps && (step == 2 || step == 5);
            ticks.push_back({value, is_named ? tick_label(step, decade) : "", step == 1});
        }
    return ticks;
}

std::string plot_html(const Plot& plot)
{
    std::vector<double> x, y;
    for (const Curve& curve : plot.curves)
        for (std::size_t i = 0; i < points_of(curve); ++i)
            if (can_show(curve.x[i]) && can_show(curve.y[i])) {
                x.push_back(curve.x[i]);
                y.push_back(curve.y[i]);
            }
    std::string html = "<div class=\"plots\">" + legend(plot);
    for (const Layout* layout : {&wide, &narrow})
        html += drawing(plot, {axis_of(x), axis_of(y), *layout});
    return html + "</div>\n";
}

Table plotted_numbers(const Plot& plot)
{
    std::map<double, std::vector<std::string>> rows;
    Table table{{plot.x_title}, {}};
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        table.columns.push_back(curve.name);
        for (std::size_t k = 0; k < points_of(curve); ++k) {
            if (std::isnan(curve.x[k]))
                continue;
            std::vector<std::string>& row = rows[curve.x[k]];
            row.resize(plot.curves.size());
            row[i] += (row[i].empty() ? "" : ", ") + number_text(curve.y[k]);
        }
    }
    for (const auto& [x, cells] : rows) {
        table.rows.push_back({number_text(x)});
        table.rows.back().insert(table.rows.back().end(), cells.begin(), cells.end());
    }
    return table;
}

} // namespace lambent::report
