#pragma once

#include "session.h"

namespace viewer {

/// Within the panel: how far the picture is and what it took, the button that saves it, the keys.
void show_status(Session& session);

}  // namespace viewer
