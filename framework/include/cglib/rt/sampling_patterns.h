#pragma once

#include <cglib/core/thread_local_data.h>

#include <glm/glm.hpp>

#include <vector>

/// count >= 1 positions in a pixel, each coordinate in [0, 1). A single one is the centre.
/// Stratified, at least one lies in each cell of the largest n x n grid with n*n <= count.
std::vector<glm::vec2> sampling_pattern(int count, bool stratified, ThreadLocalData& thread);
