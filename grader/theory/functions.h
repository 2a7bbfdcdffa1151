#pragma once
#include "theory/expression.h"

/// What a formula may call, and its operators.
namespace testat::theory {
/// A function by its name; `apply` is null if there is none.
struct Function {
    Expression::Operation apply = nullptr;
    int arity = 0;
};

/// sqrt sin cos tan asin acos atan abs length norm normalize dot cross det area. Lengths and areas are never negative;
/// area(P, Q, R) is that of a triangle. sin, cos and tan take `angles`.
Function find_function(std::string_view name, Angles angles);

/// Component x, y, z, u or v of a vector; null for other names.
Expression::Operation find_component(std::string_view name);

Value add(Value const* arguments);
Value subtract(Value const* arguments);
Value negate(Value const* arguments);
Value multiply(Value const* arguments);  ///< "*": at most one is a vector
Value divide(Value const* arguments);
Value power(Value const* arguments);
Value centre_dot(Value const* arguments);  ///< "·": scalar product of two vectors, else as "*"
Value cross_sign(Value const* arguments);  ///< "×": cross product of two vectors, else as "*"
Value length(Value const* arguments);      ///< absolute value of a number
Value degrees(Value const* arguments);     ///< to radians
}  // namespace testat::theory
