#include "stress/colours.h"

#include <algorithm>

namespace testat {
namespace {
int power_of_two(Random& random, int most)
{
    return 1 << random.integer(0, static_cast<int>(std::log2(most)));
}

template <typename Channel>
Colour of_channels(Channel const& channel)
{
    return [=](int, int, int) {
        glm::vec4 c;
        for (int i = 0; i < 4; ++i)
            c[i] = static_cast<float>(channel());
        return c;
    };
}
}  // namespace

glm::ivec2 power_of_two_size(Random& random, int side, int area)
{
    int const a = power_of_two(random, side);
    int const most = std::min(side, area / a);
    int const b =
        random.integer(0, 4) == 0 ? power_of_two(random, most) : std::clamp(a / pick(random, {1, 2, 8, a}), 1, most);
    return random.coin() ? glm::ivec2(a, b) : glm::ivec2(b, a);
}

Colour any_colour(Random& random)
{
    switch (random.integer(0, 4)) {
        case 0:
            return of_channels([&random] { return random.uniform(-1, 1); });
        case 1:
            return of_channels([&random] { return with_any_sign(random, log_uniform(random, 1e-30, 1e30)); });
        case 2: {
            double const one = random.uniform(0, 1);
            return of_channels([one] { return one; });
        }
        default:
            return of_channels([&random] { return random.integer(0, 4095) / 4096.0; });
    }
}
}  // namespace testat
