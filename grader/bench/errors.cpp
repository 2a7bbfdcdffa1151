#include "bench/errors.h"

#include <cmath>
#include <limits>

namespace testat::bench {
namespace {
/// f of CIELAB: a cube root with a linear foot.
double compressed(double t)
{
    constexpr double foot = 6.0 / 29;
    return t > foot * foot * foot ? std::cbrt(t) : t / (3 * foot * foot) + 4.0 / 29;
}

/// L*, a*, b*.
glm::dvec3 lab(glm::dvec3 rgb)
{
    rgb = glm::max(rgb, 0.0);
    // Rows of the matrix from sRGB to XYZ, each divided by its sum, which is the white point.
    double const x = compressed((0.4124 * rgb.r + 0.3576 * rgb.g + 0.1805 * rgb.b) / 0.9505);
    double const y = compressed(0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b);
    double const z = compressed((0.0193 * rgb.r + 0.1192 * rgb.g + 0.9505 * rgb.b) / 1.0890);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

bool is_finite(glm::dvec3 const& c)
{
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

/// The mean of `error(colour, truth)`, NaN if a colour is not finite.
template <typename Error>
double mean(Colours const& colours, Truth const& truth, Error const& error)
{
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        glm::dvec3 const colour(colours[i]);
        sum += is_finite(colour) ? error(colour, truth[i]) : std::numeric_limits<double>::quiet_NaN();
    }
    return sum / double(truth.size());
}
}  // namespace

double rmse(Colours const& colours, Truth const& truth)
{
    return std::sqrt(
        mean(colours, truth, [](glm::dvec3 const& a, glm::dvec3 const& b) { return glm::dot(a - b, a - b) / 3; }));
}

double mean_delta_e(Colours const& colours, Truth const& truth)
{
    return mean(colours, truth, [](glm::dvec3 const& a, glm::dvec3 const& b) { return glm::length(lab(a) - lab(b)); });
}
}  // namespace testat::bench
