#include "apps/view/canvas.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <bit>
#include <cstdint>

namespace lambent::view_window {

Canvas::Canvas()
{
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

Canvas::~Canvas()
{
    glDeleteTextures(1, &texture_);
}

void Canvas::set(const image::CodeImage& picture)
{
    glBindTexture(GL_TEXTURE_2D, texture_);
    const GLenum layout = picture.channels == 4 ? GL_RGBA : GL_RGB;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, layout, GL_UNSIGNED_BYTE,
                 picture.bytes.data());
    filled_ = true;
}

void Canvas::draw() const
{
    glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!filled_)
        return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    // Transparent pixels of the picture show this grey.
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled({0, 0}, size, IM_COL32(26, 26, 26, 255));
    list->AddImage(std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_)), {0, 0}, size);
}

} // namespace lambent::view_window
