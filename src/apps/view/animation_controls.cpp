#include "apps/view/animation_controls.h"

#include "base/text.h"

#include <imgui.h>

#include <string>

namespace lambent::view_window {
namespace {

void show_choice(viewer::Session& session, const viewer::Playing& playing)
{
    const auto name_of = [&](int number) {
        return number < 0 ? std::string("none") : playing.animations[static_cast<std::size_t>(number)].name;
    };
    if (!ImGui::BeginCombo("Animation##choice", name_of(playing.number).c_str()))
        return;
    for (int i = -1; i < static_cast<int>(playing.animations.size()); ++i)
        if (ImGui::Selectable(text(name_of(i), "##", i).c_str(), i == playing.number))
            session.animate(0, i);
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
    const double seconds =
        playing.number < 0 ? 0.0 : playing.animations[static_cast<std::size_t>(playing.number)].seconds;
    auto moment = static_cast<float>(playing.moment);
    if (seconds > 0.0 && ImGui::SliderFloat("Moment", &moment, 0.0f, static_cast<float>(seconds), "%.3f s",
                                            ImGuiSliderFlags_AlwaysClamp))
        session.seek(0, static_cast<double>(moment));
    if (ImGui::Button(playing.on ? "Pause (Space)" : "Play (Space)"))
        session.play(0, !playing.on);
}

} // namespace lambent::view_window
