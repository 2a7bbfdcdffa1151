#pragma once
#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

/// An empty vector with room for so many texels, all of which will be filled at once: their pages come in one call of
/// the system, large ones where it has some, instead of a fault for every 256 texels.
std::vector<glm::vec4> reserve_texels(std::size_t count);
