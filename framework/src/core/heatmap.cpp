#include <cglib/core/heatmap.h>

namespace {
glm::vec3 const scale[] = {{0.f, 0.f, 1.f}, {0.f, 1.f, 1.f}, {0.f, 1.f, 0.f}, {1.f, 1.f, 0.f}, {1.f, 0.f, 0.f}};
int const last = 4;
}  // namespace

glm::vec3 heatmap(float value)
{
    // The comparisons are written so that NaN ends in the first line, before it is converted to int.
    if (!(value > 0.f))
        return scale[0];
    if (value >= 1.f)
        return scale[last];
    float const position = value * float(last);
    int const below = int(position);
    // A value just below 1 may have been rounded up to the last entry.
    return below == last ? scale[last] : glm::mix(scale[below], scale[below + 1], position - float(below));
}
