#include "theory/formula.h"

#include <algorithm>
#include <cmath>

namespace testat::theory {
bool is_blank(std::string const& text)
{
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

std::vector<Variables> known_values(Opposite const& opposite)
{
    std::vector<Variables> all;
    for (auto const& triangle : random_triangles()) {
        Variables variables = variables_of(triangle);
        variables["F"] = Value::number(triangle.area);
        for (int i = 0; i < 3; ++i) {
            variables["F" + std::to_string(i + 1)] = Value::number(triangle.part(opposite[i]));
            variables[std::string("lambda_") + corner_names[i]] = Value::number(triangle.lambda[i]);
        }
        all.push_back(std::move(variables));
    }
    return all;
}

namespace {
double norm(Value const& value)
{
    return std::hypot(value.v[0], value.v[1], value.v[2]);
}

/// b * factor, component by component.
Value scaled(Value b, double factor)
{
    for (double& x : b.v)
        x *= factor;
    return b;
}
}  // namespace

std::optional<double> constant_ratio(std::vector<Value> const& a, std::vector<Value> const& b)
{
    double const sign = a[0].v[0] * b[0].v[0] < 0 ? -1 : 1;
    double const ratio = sign * norm(a[0]) / norm(b[0]);
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(std::abs(ratio) > 1e-6) || !alike(a[i], scaled(b[i], ratio)))
            return std::nullopt;
    return ratio;
}

bool alike(std::vector<Value> const& a, std::vector<Value> const& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](Value const& x, Value const& y) { return alike(x, y); });
}
}  // namespace testat::theory
