#include "status.h"

#include <imgui.h>

#include <algorithm>
#include <cinttypes>

namespace viewer {
namespace {
std::uint64_t num_rays(RenderStats const& stats)
{
    return stats.camera_rays + stats.corner_rays + stats.shadow_rays + stats.reflected_rays + stats.transmitted_rays;
}

void show_progress(PictureProgress const& progress)
{
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
    ImGui::ProgressBar(progress.fraction, ImVec2(-FLT_MIN, 6.f), "");
    ImGui::PopStyleColor();
    double const rays = double(num_rays(progress.stats));
    if (!progress.error.empty())
        ImGui::TextUnformatted("There is no picture.");
    else
        ImGui::Text("%3.0f %%, %.2f s, %.2f million rays/s", 100. * double(progress.fraction), progress.seconds,
                    1e-6 * rays / std::max(progress.seconds, 1e-6));
}

void show_stats(PictureProgress const& progress)
{
    if (!ImGui::CollapsingHeader("What the picture took") || !ImGui::BeginTable("stats", 2))
        return;
    visit_stats(progress.stats, [](char const* what, std::uint64_t count) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(what);
        ImGui::TableNextColumn();
        ImGui::Text("%12" PRIu64, count);
    });
    ImGui::EndTable();
}
}  // namespace

void show_status(Session& session)
{
    show_progress(session.progress());
    if (ImGui::Button("Save picture", ImVec2(-FLT_MIN, 0.f)))
        session.save();
    if (!session.message().empty())
        ImGui::TextWrapped("%s", session.message().c_str());
    show_stats(session.progress());
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("F4 save, Esc quit, R reset camera, Tab hide panel, 1-5 filters");
    ImGui::PopStyleColor();
}

}  // namespace viewer
