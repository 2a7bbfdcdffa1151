#pragma once
#include "functions.h"

#include <string>
#include <string_view>
#include <vector>

/// Finds the eleven functions in the text of an exercise_03.cpp, without compiling it.
namespace testat {
/// One function definition at namespace scope. Positions are byte offsets into the text.
struct Definition {
    Function function;
    std::size_t begin;   ///< first character of the return type
    std::size_t body;    ///< the opening brace
    std::size_t end;     ///< behind the closing brace
    int line;            ///< of `begin`, counted from 1
    bool closed = true;  ///< false if the next one begins before the closing brace; only recover_definitions says so
};

/// All definitions in order of appearance. Comments, literals, raw strings and preprocessor lines are skipped; text
/// that is not C++ gives what can be recognised and never fails.
std::vector<Definition> find_definitions(std::string_view text);

/// The same for text that does not compile because of its braces: a function without its closing brace ends where the
/// next of the eleven begins, one with a closing brace too many at the last of them. One whose opening brace is
/// missing, or the parenthesis behind its parameters, is found, too; `body` may be no brace then. So is one with a
/// semicolon before its opening brace.
std::vector<Definition> recover_definitions(std::string_view text);

/// The declaration at namespace scope, or in a namespace, that the line is part of, from its first character to behind
/// its semicolon or closing brace. Empty if there is none, or braces do not match.
struct Extent {
    std::size_t begin = 0;
    std::size_t end = 0;
};
Extent find_declaration(std::string_view text, int line);

/// The text with the body of `function` replaced; unchanged if it is not defined there.
std::string replace_body(std::string_view text, Function function, std::string_view body);

/// The functions whose bodies are the same in both texts, white space aside.
FunctionSet same_bodies(std::string_view text, std::string_view other);

/// `base` with the functions that `patch` defines in place of its own; whatever else `patch` holds (includes, helper
/// functions) is put before the first function.
std::string patch_definitions(std::string_view base, std::string_view patch);
}  // namespace testat
