#include "report/wrap.h"

#include <sstream>

namespace testat {
std::size_t columns_of(std::string const& utf8)
{
    std::size_t count = 0;
    bool in_escape = false;
    for (char c : utf8) {
        in_escape = in_escape || c == '\x1b';
        count += !in_escape && (c & 0xc0) != 0x80 ? 1 : 0;
        in_escape = in_escape && c != 'm';
    }
    return count;
}

std::string wrap_words(std::string const& words, std::size_t indent, std::size_t begin)
{
    std::istringstream in(words);
    std::string result;
    std::size_t column = begin;
    for (std::string word; in >> word; column += columns_of(word)) {
        bool const first = result.empty();
        bool const fits = column + 1 + columns_of(word) <= columns;
        if (!first)
            result += fits ? " " : "\n" + std::string(indent, ' ');
        column = first ? column : fits ? column + 1 : indent;
        result += word;
    }
    return result;
}

std::string wrap_words(std::string const& words, std::size_t indent)
{
    return wrap_words(words, indent, indent);
}
}  // namespace testat
