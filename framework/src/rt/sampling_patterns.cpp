#include <cglib/rt/sampling_patterns.h>

#include <cglib/core/assert.h>

#include <algorithm>

namespace {
int largest_root(int count)
{
    int n = 1;
    while ((n + 1) * (n + 1) <= count)
        ++n;
    return n;
}

glm::vec2 anywhere(ThreadLocalData& thread)
{
    float const x = thread.rand();
    return glm::vec2(x, thread.rand());
}

/// Below 1 also after rounding up.
glm::vec2 in_cell(int cell, int n, ThreadLocalData& thread)
{
    float const largest_below_one = 1.f - 0x1p-24f;
    int const row = cell / n;
    int const column = cell % n;
    glm::vec2 const position = (glm::vec2(float(column), float(row)) + anywhere(thread)) / float(n);
    return glm::min(position, glm::vec2(largest_below_one));
}
}  // namespace

std::vector<glm::vec2> sampling_pattern(int count, bool stratified, ThreadLocalData& thread)
{
    cg_assert(count >= 1);
    if (count == 1)
        return {glm::vec2(0.5f)};
    int const n = stratified ? largest_root(count) : 1;
    std::vector<glm::vec2> positions;
    for (int i = 0; i < count; ++i)
        positions.push_back(i < n * n ? in_cell(i, n, thread) : anywhere(thread));
    return positions;
}
