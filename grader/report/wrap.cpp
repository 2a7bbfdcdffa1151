#include "report/wrap.h"

#include <algorithm>
#include <sstream>

namespace testat {
std::size_t columns_of(std::string const& utf8)
{
    return std::size_t(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string wrap_words(std::string const& words, std::size_t indent)
{
    std::istringstream in(words);
    std::string result;
    std::size_t column = indent;
    for (std::string word; in >> word; column += columns_of(word)) {
        bool const first = column == indent;
        bool const fits = column + 1 + columns_of(word) <= columns;
        if (!first)
            result += fits ? " " : "\n" + std::string(indent, ' ');
        column = first ? column : fits ? column + 1 : indent;
        result += word;
    }
    return result;
}
}  // namespace testat
