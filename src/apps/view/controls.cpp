#include "apps/view/controls.h"

#include "apps/viewer/light_words.h"
#include "base/text.h"

#include <imgui.h>

#include <array>
#include <cstdio>
#include <optional>

namespace lambent::view_window {
namespace {

using viewer::OrbitCamera, viewer::Parameter, viewer::Session, viewer::ViewRequest;

// The new value of a control; unset: it was not changed.
using Moved = std::optional<std::string>;

Moved number(const cli::Control& row, const std::string& label, const std::string& word)
{
    float value = word.empty() ? static_cast<float>(row.least) : std::stof(word);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                   (row.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    if (!ImGui::SliderFloat(label.c_str(), &value, static_cast<float>(row.least),
                            static_cast<float>(row.most), word.empty() ? "not set" : "%.4g", flags))
        return std::nullopt;
    return viewer::number_word(static_cast<double>(value));
}

Moved whole(const cli::Control& row, const std::string& label, const std::string& word)
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
    for (const std::string& one : viewer::choices_of(row))
        if (ImGui::Selectable(one.c_str(), one == word))
            moved = one;
    ImGui::EndCombo();
    return moved;
}

// The word has linear values, the colour picker sRGB.
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

// Shows a button that unsets an optional parameter.
Moved unset(const Parameter& row, const std::string& word)
{
    if (!row.option.usual.empty() || word.empty())
        return std::nullopt;
    ImGui::SameLine();
    if (!ImGui::SmallButton(text("x##", row.option.name).c_str()))
        return std::nullopt;
    return std::string();
}

Moved control(const Parameter& row, const std::string& word)
{
    const cli::Control& how = row.option.control;
    const std::string label = text(how.label, "##", row.option.name);
    switch (viewer::kind_of(row)) {
    case viewer::Kind::number:
        return number(how, label, word);
    case viewer::Kind::whole:
        return whole(how, label, word);
    case viewer::Kind::choice:
        return choice(row, label, word);
    default:
        return color(label, word);
    }
}

void set(Session& session, const Parameter& row, const std::string& word)
{
    session.change(0, [&](ViewRequest& request, const OrbitCamera::World&) {
        viewer::set_value(request.asked, row.option.name, word);
    });
}

} // namespace

void show_controls(Session& session, const cli::RenderArguments& asked)
{
    std::string_view group;
    bool open = false;
    for (const Parameter* const parameter : viewer::parameters()) {
        const Parameter& row = *parameter;
        if (row.option.control.group != group) {
            group = row.option.control.group;
            open = ImGui::CollapsingHeader(std::string(group).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        }
        if (!open || !cli::applies(row.option.needs, asked))
            continue;
        const std::string word = row.value.get(asked, row.option);
        Moved moved = control(row, word);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
            moved = std::string(row.option.usual);
        if (moved)
            set(session, row, *moved);
        else if (const Moved nothing = unset(row, word))
            set(session, row, *nothing);
    }
}

} // namespace lambent::view_window
