#pragma once

#include "cameras.h"
#include "display.h"

#include <cglib/rt/raytracing_parameters.h>

#include <string>

namespace viewer {

/// What one can change: widgets, keys and scripts all edit this.
struct State {
    std::string scene;
    /// Width and height count only if the size is fixed.
    RaytracingParameters params;
    /// Else the picture fills the space there is.
    bool size_is_fixed = false;
    View view;
    /// Else the camera orbits.
    bool flies = false;
    Exposure exposure;
    bool shows_panel = true;
};

}  // namespace viewer
