#include "status.h"

#include <imgui.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>

namespace viewer {
namespace {
std::uint64_t num_rays(RenderStats const& stats)
{
    return stats.camera_rays + stats.corner_rays + stats.shadow_rays + stats.reflected_rays + stats.transmitted_rays;
}

void show_progress(PictureProgress const& progress)
{
    char text[96];
    double const rays = double(num_rays(progress.stats));
    if (!progress.error.empty())
        std::snprintf(text, sizeof text, "failed");
    else
        std::snprintf(text, sizeof text, "%.2f s, %.2f million rays/s", progress.seconds,
                      1e-6 * rays / std::max(progress.seconds, 1e-6));
    ImGui::ProgressBar(progress.fraction, ImVec2(-FLT_MIN, 0.f), text);
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
