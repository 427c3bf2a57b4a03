#include "apps/view/animation_controls.h"

#include "base/text.h"

#include <imgui.h>

#include <string>

namespace lambent::view_window {
namespace {

void show_choice(viewer::Session& session, const viewer::Playing& playing)
{
    if (!ImGui::BeginCombo("Animation##choice", playing.now.name.c_str()))
        return;
    if (ImGui::Selectable("none", playing.number < 0))
        session.animate(0, -1);
    for (std::size_t i = 0; i < playing.animations.size(); ++i) {
        const int number = static_cast<int>(i);
        if (ImGui::Selectable(text(playing.animations[i].name, "##", i).c_str(), number == playing.number))
            session.animate(0, number);
    }
    ImGui::EndCombo();
}

} // namespace

void show_animation(viewer::Session& session)
{
    const viewer::Playing playing = session.playing();
    if (playing.animations.empty() ||
        !ImGui::CollapsingHeader("Animation##group", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    show_choice(session, playing);
    const double seconds = playing.now.seconds;
    auto moment = static_cast<float>(playing.moment);
    if (seconds > 0.0 && ImGui::SliderFloat("Time", &moment, 0.0f, static_cast<float>(seconds), "%.3f s",
                                            ImGuiSliderFlags_AlwaysClamp))
        session.seek(0, static_cast<double>(moment));
    if (ImGui::Button(playing.on ? "Pause (Space)" : "Play (Space)"))
        session.play(0, !playing.on);
}

} // namespace lambent::view_window
