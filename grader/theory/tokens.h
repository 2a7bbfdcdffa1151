#pragma once
#include "theory/expression.h"

#include <string>
#include <string_view>
#include <vector>

namespace testat::theory {
/// A word of a formula.
struct Token {
    enum class Kind { number, name, sign, end } kind = Kind::end;
    std::string text;       ///< a name or a sign; λ is "lambda", a prime is part of its name
    double number = 0;      ///< finite
    std::size_t place = 1;  ///< of its first character, from 1
};

/// Splits a formula; the last token is the end. Throws Refused for what is no part of a formula.
std::vector<Token> tokens_of(std::string_view text);

/// "At character 7: ..."
Refused refused_at(std::size_t place, Phrase const& why);
}  // namespace testat::theory
