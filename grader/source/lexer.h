#pragma once
#include <string>
#include <string_view>
#include <vector>

/// C++ text cut into words, without compiling it.
namespace testat {
/// An identifier or a single other character. Positions are byte offsets into the text.
struct Token {
    std::size_t begin;
    std::size_t end;
    bool identifier;
};

struct Lexed {
    std::vector<Token> tokens;
    /// What #include lines name, in order, as far as nothing can change what they mean: those in #if and those behind a
    /// #define or #undef are left out.
    std::vector<std::string> includes;
};

/// Comments, literals, raw strings, numbers and preprocessor lines are skipped, and what `#if 0` leaves out. Text that
/// is not C++ gives what can be recognised and never fails.
Lexed lex(std::string_view text);
}  // namespace testat
