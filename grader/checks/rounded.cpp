#include "checks/rounded.h"

namespace testat {
RoundedTransform inverse(RoundedTransform const& m)
{
    auto const& c = m.columns;
    RoundedTransform const rows = {{cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])}, {}};
    Rounded const scale = Rounded(1) / dot(c[0], rows.columns[0]);
    RoundedTransform result = transpose(rows);
    for (auto& column : result.columns)
        column = scale * column;
    RoundedVector const& t = m.translation;
    RoundedVector const moved = {-dot(c[1], cross(c[2], t)), dot(c[0], cross(c[2], t)), -dot(c[0], cross(c[1], t))};
    result.translation = scale * moved;
    return result;
}
}  // namespace testat
