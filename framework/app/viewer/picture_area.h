#pragma once

#include "session.h"

#include <glm/glm.hpp>

namespace viewer {

/// The part of the window that the picture may fill, in ImGui's units from the upper left.
struct Area {
    glm::vec2 position;
    /// >= 1.
    glm::vec2 size;
};

/// What the panel leaves, if it is shown.
Area picture_area(State const& state);

/// Shows the picture (an OpenGL texture) in the middle of the area: pixel by pixel, enlarged by a whole number, or
/// scaled down to fit; what went wrong is written over it. Returns what the mouse did there.
CameraInput show_picture(Session const& session, unsigned texture, Area const& area, glm::vec2 const& pixel_scale);

}  // namespace viewer
