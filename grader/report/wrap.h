#pragma once
#include <string>

namespace testat {
/// Width of texts for people.
constexpr std::size_t columns = 80;

/// Terminal columns of UTF-8 text, for letters that are one column wide; colours have none.
std::size_t columns_of(std::string const& utf8);

/// Words on as many lines of 80 columns as it takes, each but the first indented, which begins in column `begin`; a
/// longer word has a line of its own.
std::string wrap_words(std::string const& words, std::size_t indent, std::size_t begin);
std::string wrap_words(std::string const& words, std::size_t indent);
}  // namespace testat
