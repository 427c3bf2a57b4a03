#include "apps/view/controls.h"

#include "apps/viewer/light_words.h"
#include "base/text.h"

#include <imgui.h>

#include <array>
#include <cstdio>
#include <optional>
#include <sstream>

namespace lambent::view_window {
namespace {

using viewer::Eye, viewer::Kind, viewer::Parameter, viewer::Session, viewer::Wish;

// A value that a control was moved to.
using Moved = std::optional<std::string>;

Moved number(const Parameter& row, const std::string& label, const std::string& word)
{
    float value = word.empty() ? static_cast<float>(row.least) : std::stof(word);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                   (row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    if (!ImGui::SliderFloat(label.c_str(), &value, static_cast<float>(row.least),
                            static_cast<float>(row.most), word.empty() ? "not set" : "%.4g", flags))
        return std::nullopt;
    return viewer::number_word(static_cast<double>(value));
}

Moved whole(const Parameter& row, const std::string& label, const std::string& word)
{
    int value = word.empty() ? static_cast<int>(row.least) : std::stoi(word);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                   (row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    if (!ImGui::SliderInt(label.c_str(), &value, static_cast<int>(row.least), static_cast<int>(row.most),
                          "%d", flags))
        return std::nullopt;
    return text(value);
}

Moved choice(const Parameter& row, const std::string& label, const std::string& word)
{
    Moved moved;
    if (!ImGui::BeginCombo(label.c_str(), word.c_str()))
        return moved;
    std::istringstream words{std::string(row.choices)};
    for (std::string one; words >> one;)
        if (ImGui::Selectable(one.c_str(), one == word))
            moved = one;
    ImGui::EndCombo();
    return moved;
}

// Words are linear, the picker is not.
Moved color(const std::string& label, const std::string& word)
{
    std::array<double, 3> linear = {0.2, 0.2, 0.2};
    std::sscanf(word.c_str(), "%lf,%lf,%lf", &linear[0], &linear[1], &linear[2]);
    const std::array<double, 3> screen = viewer::screen_color(linear);
    std::array<float, 3> rgb = {static_cast<float>(screen[0]), static_cast<float>(screen[1]),
                                static_cast<float>(screen[2])};
    if (!ImGui::ColorEdit3(label.c_str(), rgb.data()))
        return std::nullopt;
    linear = viewer::linear_color(
        {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])});
    return text(viewer::number_word(linear[0]), ",", viewer::number_word(linear[1]), ",",
                viewer::number_word(linear[2]));
}

// Takes a value away from a row that need not have one.
Moved unset(const Parameter& row, const std::string& word)
{
    if (!row.may_be_empty() || word.empty())
        return std::nullopt;
    ImGui::SameLine();
    if (!ImGui::SmallButton(text("x##", row.name).c_str()))
        return std::nullopt;
    return std::string();
}

Moved control(const Parameter& row, const std::string& word)
{
    const std::string label = text(row.label, "##", row.name);
    switch (row.kind) {
    case Kind::number:
        return number(row, label, word);
    case Kind::whole:
        return whole(row, label, word);
    case Kind::choice:
        return choice(row, label, word);
    default:
        return color(label, word);
    }
}

void set(Session& session, const Parameter& row, const std::string& word)
{
    session.change(0, [&](Wish& wish, const Eye::World&) { wish.values.set(row.name, word); });
}

} // namespace

void show_controls(Session& session, const viewer::Values& values, bool built_in)
{
    std::string_view group;
    bool open = false;
    for (const Parameter& row : viewer::parameters()) {
        if (row.group != group) {
            group = row.group;
            open = ImGui::CollapsingHeader(std::string(group).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        }
        if (!open || !values.applies(row, built_in))
            continue;
        Moved moved = control(row, values[row.name]);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
            moved = std::string(row.usual);
        if (moved)
            set(session, row, *moved);
        else if (const Moved nothing = unset(row, values[row.name]))
            set(session, row, *nothing);
    }
}

} // namespace lambent::view_window
