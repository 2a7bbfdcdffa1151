#include <cglib/rt/bounds.h>

bool Bounds::is_finite() const
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(lower[axis] > -FLT_MAX && upper[axis] < FLT_MAX))
            return false;
    return true;
}

Bounds Bounds::around(Bounds const& a, Bounds const& b)
{
    return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

Bounds Bounds::around(glm::vec3 const* points, int count)
{
    Bounds bounds{points[0], points[0]};
    for (int i = 1; i < count; ++i)
        bounds = around(bounds, {points[i], points[i]});
    return bounds;
}
