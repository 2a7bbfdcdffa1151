#include "theory/triangles.h"

#include "checks/random.h"
#include "theory/functions.h"

#include <algorithm>
#include <cmath>

namespace testat::theory {
namespace {
Value combined(std::array<Value, 3> const& values, std::array<double, 3> const& weights)
{
    Value sum = values[0];
    for (int i = 0; i < 3; ++i)
        sum.v[i] = weights[0] * values[0].v[i] + weights[1] * values[1].v[i] + weights[2] * values[2].v[i];
    return sum;
}

std::array<double, 3> random_weights(Random& random)
{
    std::array<double, 3> w{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
    double const sum = w[0] + w[1] + w[2];
    for (double& x : w)
        x /= sum;
    return w;
}

Triangle random_triangle(Random& random)
{
    Triangle t;
    for (auto& corner : t.corners)
        corner = Value::triple(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
    for (auto& uv : t.uv)
        uv = Value::pair(random.uniform(-2, 3), random.uniform(-2, 3));
    t.lambda = random_weights(random);
    t.p = combined(t.corners, t.lambda);
    t.area = find_function("area", Angles::radians).apply(t.corners.data()).v[0];
    return t;
}

bool is_fit(Triangle const& t)
{
    auto const [a, b, c] = t.lambda;
    return t.area > 2 && std::min({std::abs(a - b), std::abs(b - c), std::abs(c - a)}) > 0.02;
}
}  // namespace

std::vector<Triangle> const& random_triangles()
{
    static std::vector<Triangle> const triangles = [] {
        constexpr std::size_t count = 64;
        Random random(1, "Theory.Barycentric");
        std::vector<Triangle> result;
        while (result.size() < count)
            if (Triangle const t = random_triangle(random); is_fit(t))
                result.push_back(t);
        return result;
    }();
    return triangles;
}

Variables variables_of(Triangle const& t)
{
    return {{"A", t.corners[0]}, {"B", t.corners[1]}, {"C", t.corners[2]}, {"P", t.p},
            {"A'", t.uv[0]},     {"B'", t.uv[1]},     {"C'", t.uv[2]}};
}

std::vector<Value> values_of(Expression const& formula, std::vector<Variables> const& variables, int size)
{
    std::vector<Value> values;
    for (auto const& v : variables) {
        Value const value = formula.evaluate(v);
        if (value.size != size && size == 1)
            throw Refused{{"Das ergibt einen Vektor; gesucht ist eine Zahl. Fehlt eine Länge, length(...)?",
                           "This is a vector; wanted is a number. Is a length missing, length(...)?"}};
        if (value.size != size)
            throw Refused{{value.size == 1 ? "Das ergibt eine Zahl; gesucht sind Texturkoordinaten (u, v)."
                                           : "Das ergibt einen Punkt im Raum; gesucht sind Texturkoordinaten (u, v).",
                           value.size == 1 ? "This is a number; wanted are texture coordinates (u, v)."
                                           : "This is a point in space; wanted are texture coordinates (u, v)."}};
        for (int i = 0; i < size; ++i)
            if (!std::isfinite(value.v[i]))
                throw Refused{
                    {"Das ergibt nicht immer eine endliche Zahl: wird durch 0 geteilt, oder eine Wurzel aus "
                     "etwas Negativem gezogen?",
                     "This is not always a finite number: is there a division by 0, or a root of something "
                     "negative?"}};
        values.push_back(value);
    }
    return values;
}

bool alike(Value const& a, Value const& b)
{
    constexpr double rounding = 1e-6;
    bool result = a.size == b.size;
    for (int i = 0; i < a.size; ++i)
        result = result && std::abs(a.v[i] - b.v[i]) <= rounding * (1 + std::abs(b.v[i]));
    return result;
}
}  // namespace testat::theory
