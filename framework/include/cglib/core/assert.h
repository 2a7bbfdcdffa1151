#pragma once

#include <cassert>
#include <cstdio>
#include <cstdlib>

namespace cg {
/// Prints the expression with its place to stderr and aborts.
[[noreturn]] void assertion_failed(char const* expression, char const* file, int line);
}  // namespace cg

/// Aborts when the expression is false: in every build type, unlike assert().
#define cg_assert(...) ((__VA_ARGS__) ? (void)0 : ::cg::assertion_failed(#__VA_ARGS__, __FILE__, __LINE__))
