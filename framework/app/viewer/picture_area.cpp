#include "picture_area.h"

#include "controls.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace viewer {
namespace {
ImVec2 imgui(glm::vec2 const& v)
{
    return ImVec2(v.x, v.y);
}

/// In ImGui's units.
glm::vec2 shown_size(DisplayPicture const& picture, glm::vec2 const& space, glm::vec2 const& pixel_scale)
{
    glm::vec2 const size = glm::vec2(picture.width(), picture.height()) / pixel_scale;
    float const fitting = std::min(space.x / size.x, space.y / size.y);
    return size * (fitting >= 1.f ? std::floor(fitting) : fitting);
}

glm::vec2 drag(ImGuiMouseButton button, float height)
{
    ImVec2 const delta = ImGui::GetIO().MouseDelta;
    return ImGui::IsMouseDown(button) ? glm::vec2(delta.x, -delta.y) / height : glm::vec2(0.f);
}

/// A button as large as the area keeps drags that began in it, wherever the mouse goes.
CameraInput mouse_input(Area const& area)
{
    CameraInput input;
    ImGui::SetCursorScreenPos(imgui(area.position));
    ImGui::InvisibleButton(
        "mouse", imgui(area.size),
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    if (ImGui::IsItemActive()) {
        input.left_drag = drag(ImGuiMouseButton_Left, area.size.y);
        input.middle_drag = drag(ImGuiMouseButton_Middle, area.size.y);
        input.right_drag = drag(ImGuiMouseButton_Right, area.size.y);
    }
    if (ImGui::IsItemHovered())
        input.wheel = ImGui::GetIO().MouseWheel;
    return input;
}

void show_error(std::string const& error, Area const& area)
{
    ImVec2 const margin(16.f, 16.f);
    ImGui::SetCursorScreenPos(ImVec2(area.position.x + margin.x, area.position.y + margin.y));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 210, 200, 255));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(90, 20, 20, 235));
    ImGui::BeginChild("error", ImVec2(area.size.x - 2.f * margin.x, 5.f * ImGui::GetTextLineHeight()), true);
    ImGui::TextWrapped("There is no such picture: %s", error.c_str());
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}
}  // namespace

Area picture_area(State const& state)
{
    ImVec2 const window = ImGui::GetIO().DisplaySize;
    float const left = state.shows_panel ? panel_width : 0.f;
    return {glm::vec2(left, 0.f), glm::vec2(std::max(1.f, window.x - left), std::max(1.f, window.y))};
}

CameraInput show_picture(Session const& session, unsigned texture, Area const& area, glm::vec2 const& pixel_scale)
{
    ImGui::SetNextWindowPos(imgui(area.position));
    ImGui::SetNextWindowSize(imgui(area.size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.f, 0.f));
    ImGui::Begin("Picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (session.display().width() > 0) {
        glm::vec2 const size = shown_size(session.display(), area.size, pixel_scale);
        ImGui::SetCursorScreenPos(imgui(glm::floor(area.position + 0.5f * (area.size - size))));
        // Row 0 is the bottom.
        ImGui::Image(reinterpret_cast<void*>(std::uintptr_t(texture)), imgui(size), ImVec2(0.f, 1.f), ImVec2(1.f, 0.f));
    }
    CameraInput const input = mouse_input(area);
    ImGui::PopStyleVar();
    if (!session.progress().error.empty())
        show_error(session.progress().error, area);
    ImGui::End();
    return input;
}

}  // namespace viewer
