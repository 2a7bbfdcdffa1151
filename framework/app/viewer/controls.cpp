#include "controls.h"

#include "status.h"

#include "../choices.h"

#include <cglib/rt/scenes.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace viewer {
namespace {
char const* const mode_labels[RENDER_MODE_COUNT] = {"Shaded", "Shaded, grey", "Number of rays",
                                                    "Normal", "Time",         "du dv"};
int const largest_side = 16384;

/// A combo for an enum whose values are the indices of labels.
template <class Enum>
void choose(char const* label, Enum& value, char const* const* labels, int count)
{
    int index = value;
    if (ImGui::Combo(label, &index, labels, count))
        value = Enum(index);
}

void choose_scene(State& state)
{
    if (!ImGui::BeginCombo("Scene", state.scene.c_str()))
        return;
    for (std::string const& name : scene_names()) {
        if (ImGui::Selectable(name.c_str(), name == state.scene))
            state.scene = name;
        if (name == state.scene)
            ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
}

void show_choices(State& state)
{
    RaytracingParameters& params = state.params;
    choose_scene(state);
    choose("Mode", params.render_mode, mode_labels, RENDER_MODE_COUNT);
    choose("Filter", params.tex_filter_mode, tex_filter_mode_names, TEXTURE_FILTER_MODE_COUNT);
    choose("Wrap", params.tex_wrap_mode, tex_wrap_mode_names, TEXTURE_WRAP_MODE_COUNT);
    bool const has_footprints = params.tex_filter_mode == TRILINEAR || params.tex_filter_mode == DEBUG_MIP;
    if (params.render_mode == DUDV && !has_footprints)
        ImGui::TextWrapped("Only the filters Trilinear and Debug Mip need du dv: choose one of them to see it.");
}

void show_switches(RaytracingParameters& params)
{
    float const column = 0.5f * ImGui::GetWindowContentRegionMax().x;
    bool left = true;
    for (Switch const& entry : switches()) {
        if (!left)
            ImGui::SameLine(column);
        ImGui::Checkbox(entry.label, &(params.*entry.value));
        left = !left;
    }
}

void show_field_of_view(RaytracingParameters& params)
{
    float const vertical = glm::degrees(2.f * std::atan(0.5f * std::tan(glm::radians(params.fovy))));
    char format[64];
    std::snprintf(format, sizeof format, "%%.1f (vertical %.2f\u00b0)", double(vertical));
    ImGui::SliderFloat("Field of view", &params.fovy, 5.f, 80.f, format, ImGuiSliderFlags_AlwaysClamp);
}

void show_sliders(State& state)
{
    RaytracingParameters& params = state.params;
    int const exact = ImGuiSliderFlags_AlwaysClamp;
    int const logarithmic = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
    ImGui::SliderInt("Depth", &params.max_depth, 0, 16, "%d", exact);
    ImGui::SliderInt("Samples", &params.spp, 1, 256, "%d per pixel", logarithmic);
    ImGui::SliderFloat("Epsilon", &params.ray_epsilon, 1e-5f, 1e-1f, "%.5f", logarithmic);
    show_field_of_view(params);
    ImGui::SliderFloat("Exposure", &state.exposure.stops, -5.f, 5.f, "%+.2f stops", exact);
    ImGui::SliderFloat("Gamma", &state.exposure.gamma, 1.f, 3.f, "%.2f", exact);
}

void show_size(State& state, Image const& picture)
{
    ImGui::Checkbox("Fixed size", &state.size_is_fixed);
    ImGui::SameLine();
    if (!state.size_is_fixed) {
        ImGui::TextDisabled("%d x %d", picture.getWidth(), picture.getHeight());
        return;
    }
    int size[2] = {state.params.width, state.params.height};
    ImGui::SetNextItemWidth(-FLT_MIN);
    // Not while digits are being typed: that would render pictures of a single pixel.
    ImGui::InputInt2("##size", size, ImGuiInputTextFlags_None);
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        state.params.width = std::clamp(size[0], 1, largest_side);
        state.params.height = std::clamp(size[1], 1, largest_side);
    }
}

void show_camera(Session& session)
{
    State& state = session.state;
    if (ImGui::RadioButton("Orbit", !state.flies))
        state.flies = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("Fly", state.flies))
        state.flies = true;
    ImGui::SameLine();
    if (ImGui::Button("Reset camera"))
        session.reset_view();
    ImGui::TextDisabled(state.flies ? "W A S D Q E move, drag turns" : "Drag turns, wheel: distance, middle: pan");
}
}  // namespace

void show_panel(Session& session)
{
    ImGui::SetNextWindowPos(ImVec2(0.f, 0.f));
    ImGui::SetNextWindowSize(ImVec2(panel_width, ImGui::GetIO().DisplaySize.y));
    ImGui::Begin("Panel", nullptr, ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar);
    ImGui::PushItemWidth(0.62f * panel_width);
    show_choices(session.state);
    ImGui::Separator();
    show_switches(session.state.params);
    ImGui::Separator();
    show_sliders(session.state);
    ImGui::Separator();
    show_size(session.state, session.picture());
    show_camera(session);
    ImGui::Separator();
    show_status(session);
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace viewer
