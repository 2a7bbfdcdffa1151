#pragma once

#include <glm/glm.hpp>

/// A colour scale: blue, cyan, green, yellow, red at 0, 0.25, 0.5, 0.75 and 1, linear in between.
/// Values outside [0, 1] are clamped, NaN is shown as 0.
glm::vec3 heatmap(float value);
