#include "checks/footprint.h"

namespace testat {
namespace {
void mend_seam(Corner& a, Corner& b)
{
    for (int axis = 0; axis < 2; ++axis) {
        if (!(a.offset[axis] * b.offset[axis] > 0))
            continue;
        bool const a_longer = std::abs(a.offset[axis]) > std::abs(b.offset[axis]);
        (a_longer ? a : b).offset[axis] = -(a_longer ? b : a).offset[axis];
    }
}
}  // namespace

Corner map_corner(FootprintQuestion const& q, glm::dvec3 position, double error)
{
    glm::dvec2 const uv = map_uv(q.shape, position);
    glm::dvec2 change(8 * eps * (glm::abs(uv) + 1.0));
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 moved = position;
        moved[axis] += error;
        change += glm::abs(map_uv(q.shape, moved) - uv);
    }
    return {uv - dvec2(q.uv), change};
}

void mend_seams(Corner (&corners)[4])
{
    mend_seam(corners[0], corners[1]);
    mend_seam(corners[2], corners[3]);
}
}  // namespace testat
