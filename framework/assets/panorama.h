#pragma once

#include "room.h"

#include <cglib/core/image.h>

/// What is seen from the origin in all directions, encoded for gamma 2; 2048 x 1024 texels. Direction d is at
/// ((atan2(d.z, d.x) + pi) / 2pi, (asin(d.y) + pi/2) / pi) of the picture's width and height.
Image make_panorama(Room const& room);
