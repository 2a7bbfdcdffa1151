#pragma once

#include "session.h"

namespace viewer {

/// In ImGui's units.
constexpr float panel_width = 330.f;

/// The panel at the left: what one can change, and how far the picture is.
void show_panel(Session& session);

}  // namespace viewer
