#include "theory/functions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace testat::theory {
namespace {
constexpr double pi = 3.14159265358979323846;

void must_be_number(Value const& value, Phrase const& why)
{
    if (value.size != 1)
        throw Refused{why};
}

void must_be_alike(Value const& a, Value const& b, Phrase const& why)
{
    if (a.size != b.size)
        throw Refused{why};
}

template <double (*f)(double)>
Value of_number(Value const* a)
{
    must_be_number(a[0], {"Wurzel, Sinus, Kosinus usw. nehmen eine Zahl, keinen Vektor.",
                          "Roots, sines, cosines and the like take a number, not a vector."});
    return Value::number(f(a[0].v[0]));
}

template <double (*f)(double)>
Value of_degrees(Value const* a)
{
    Value const radians = degrees(a);
    return of_number<f>(&radians);
}

double sum_of_products(Value const& a, Value const& b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

Value dot(Value const* a)
{
    must_be_alike(a[0], a[1],
                  {"Ein Skalarprodukt braucht zwei Vektoren mit gleich vielen Komponenten.",
                   "A scalar product takes two vectors with as many components."});
    return Value::number(sum_of_products(a[0], a[1]));
}

Value cross(Value const* a)
{
    if (a[0].size != 3 || a[1].size != 3)
        throw Refused{{"Ein Kreuzprodukt braucht zwei Vektoren mit drei Komponenten.",
                       "A cross product takes two vectors of three components."}};
    auto const& [p, q] = std::pair(a[0].v, a[1].v);
    return Value::triple(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
}

Value normalize(Value const* a)
{
    Value const operands[] = {a[0], length(a)};
    return divide(operands);
}

/// Of three columns.
Value det(Value const* a)
{
    Value const operands[] = {a[0], cross(a + 1)};
    return dot(operands);
}

Value area(Value const* a)
{
    Value const first[] = {a[1], a[0]}, second[] = {a[2], a[0]};
    Value const edges[] = {subtract(first), subtract(second)};
    Value const normal = cross(edges);
    return Value::number(length(&normal).v[0] / 2);
}

struct Named {
    std::string_view name;
    Function function;
};

constexpr Named functions[] = {
    {"sqrt", {of_number<std::sqrt>, 1}},
    {"asin", {of_number<std::asin>, 1}},
    {"acos", {of_number<std::acos>, 1}},
    {"atan", {of_number<std::atan>, 1}},
    {"abs", {length, 1}},
    {"length", {length, 1}},
    {"norm", {length, 1}},
    {"normalize", {normalize, 1}},
    {"dot", {dot, 2}},
    {"cross", {cross, 2}},
    {"det", {det, 3}},
    {"area", {area, 3}},
};
constexpr Named of_angles[] = {
    {"sin", {of_number<std::sin>, 1}}, {"cos", {of_number<std::cos>, 1}}, {"tan", {of_number<std::tan>, 1}}};
constexpr Named of_angles_in_degrees[] = {
    {"sin", {of_degrees<std::sin>, 1}}, {"cos", {of_degrees<std::cos>, 1}}, {"tan", {of_degrees<std::tan>, 1}}};

template <std::size_t size>
Function find(Named const (&table)[size], std::string_view name)
{
    auto const found = std::find_if(table, table + size, [&](Named const& n) { return n.name == name; });
    return found == table + size ? Function{} : found->function;
}

template <int index>
Value component(Value const* a)
{
    if (a[0].size <= std::max(index, 1))
        throw Refused{{"Diese Komponente gibt es nicht: Punkte haben x, y und z, Texturkoordinaten u und v.",
                       "There is no such component: points have x, y and z, texture coordinates u and v."}};
    return Value::number(a[0].v[index]);
}

template <typename F>
Value by_component(Value const* a, F f)
{
    must_be_alike(a[0], a[1],
                  {"Plus und Minus verbinden Zahlen mit Zahlen und Vektoren mit gleich langen Vektoren.",
                   "Plus and minus join numbers with numbers, and vectors with vectors of as many components."});
    Value result = a[0];
    for (int i = 0; i < result.size; ++i)
        result.v[i] = f(a[0].v[i], a[1].v[i]);
    return result;
}
}  // namespace

Function find_function(std::string_view name, Angles angles)
{
    Function const found = angles == Angles::radians ? find(of_angles, name) : find(of_angles_in_degrees, name);
    return found.apply != nullptr ? found : find(functions, name);
}

Expression::Operation find_component(std::string_view name)
{
    if (name == "x" || name == "u")
        return component<0>;
    if (name == "y" || name == "v")
        return component<1>;
    return name == "z" ? component<2> : nullptr;
}

Value add(Value const* a)
{
    return by_component(a, [](double x, double y) { return x + y; });
}

Value subtract(Value const* a)
{
    return by_component(a, [](double x, double y) { return x - y; });
}

Value negate(Value const* a)
{
    return {{-a[0].v[0], -a[0].v[1], -a[0].v[2]}, a[0].size};
}

Value multiply(Value const* a)
{
    Value const& scale = a[0].size == 1 ? a[0] : a[1];
    Value result = a[0].size == 1 ? a[1] : a[0];
    must_be_number(scale, {"Zwei Vektoren verbindet dot(a, b) oder cross(a, b), nicht das Malzeichen.",
                           "Two vectors are joined by dot(a, b) or cross(a, b), not by the asterisk."});
    for (double& x : result.v)
        x *= scale.v[0];
    return result;
}

Value divide(Value const* a)
{
    must_be_number(a[1], {"Durch einen Vektor kann man nicht teilen; meinen Sie seine Länge, length(...)?",
                          "Nothing can be divided by a vector; do you mean its length, length(...)?"});
    Value result = a[0];
    for (int i = 0; i < result.size; ++i)
        result.v[i] /= a[1].v[0];
    return result;
}

Value power(Value const* a)
{
    for (int i : {0, 1})
        must_be_number(a[i], {"Potenzen gibt es nur von Zahlen; das Quadrat eines Vektors ist dot(a, a).",
                              "Only numbers have powers; the square of a vector is dot(a, a)."});
    return Value::number(std::pow(a[0].v[0], a[1].v[0]));
}

Value centre_dot(Value const* a)
{
    return a[0].size == 1 || a[1].size == 1 ? multiply(a) : dot(a);
}

Value cross_sign(Value const* a)
{
    return a[0].size == 1 || a[1].size == 1 ? multiply(a) : cross(a);
}

Value length(Value const* a)
{
    if (a[0].size == 1)
        return Value::number(std::abs(a[0].v[0]));
    return Value::number(std::sqrt(sum_of_products(a[0], a[0])));
}

Value degrees(Value const* a)
{
    must_be_number(a[0], {"Das Gradzeichen steht hinter einer Zahl.", "The degree sign stands behind a number."});
    return Value::number(a[0].v[0] * pi / 180);
}
}  // namespace testat::theory
