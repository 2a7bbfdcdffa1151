#pragma once
#include "model.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Formulas that students write: numbers, points and vectors. No library of Debian's knows vectors and is safe on
/// hostile text, so this is ours: a text has a largest length and depth, and is evaluated in one pass over its steps.
namespace testat::theory {
/// An answer that cannot be read or evaluated, and why. Thrown and caught within theory/; students see the sentence.
struct Refused {
    Phrase why;
};

/// A number, or a vector of two or three components.
struct Value {
    std::array<double, 3> v{};
    int size = 1;  ///< 1 for a number

    static Value number(double x) { return {{x, 0, 0}, 1}; }
    static Value pair(double x, double y) { return {{x, y, 0}, 2}; }
    static Value triple(double x, double y, double z) { return {{x, y, z}, 3}; }
};

using Variables = std::map<std::string, Value, std::less<>>;

/// What sin, cos and tan take where no degree sign stands.
enum class Angles { radians, degrees };

constexpr std::size_t longest_expression = 2000;  ///< bytes
constexpr int deepest_expression = 100;           ///< parentheses, signs and exponents within each other

/// A formula such as "length(cross(B - P, C - P)) / 2", "|B - A|", "cos(90°)", "lambda_A * A'.u". Operators are + - * /
/// ^, · and × for vectors; functions are listed in functions.cpp. λ is read as lambda, π as pi, ½ as 0.5.
class Expression {
public:
    /// Throws Refused with the place.
    explicit Expression(std::string_view text, Angles angles = Angles::radians);

    /// May be NaN or infinite. Throws Refused for unknown names, and where numbers and vectors do not go together.
    Value evaluate(Variables const& variables) const;

    /// Names that are used, each once or more.
    std::vector<std::string> names() const;

    /// Takes `arity` values and gives one. Throws Refused.
    using Operation = Value (*)(Value const* arguments);

    /// In the order of evaluation: operands before operators.
    struct Step {
        Operation apply = nullptr;  ///< if null: `variable`, or `constant` where that is empty
        int arity = 0;
        Value constant;
        std::string variable;
    };

private:
    std::vector<Step> steps_;
};
}  // namespace testat::theory
