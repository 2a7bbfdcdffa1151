#pragma once

#include "room.h"

/// The blocks that matter within a cone around an axis (unit) that starts at the origin.
struct ViewBlocks {
    /// Those that can be seen.
    BlockList seen;
    /// Those that can darken what is seen.
    BlockList nearby;
};

/// May list a few blocks too many. The angle is that between axis and border.
ViewBlocks find_view_blocks(Room const& room, glm::vec3 const& axis, float cone_angle);
