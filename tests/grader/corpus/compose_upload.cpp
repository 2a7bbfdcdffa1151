// Build tool: a patch of the corpus as a whole upload, with the patch's first line (its verdict) first:
// compose_upload BASE PATCH OUT. A patch with CRLF line ends gives a file with CRLF line ends.
#include "source/definitions.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace {
std::string read(char const* file)
{
    std::ifstream in(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(in), {});
    if (!in || text.empty())
        throw std::runtime_error(std::string(file) + ": cannot be read, or is empty");
    return text;
}

std::string with_crlf(std::string const& text)
{
    std::string result;
    for (char c : text)
        if (c != '\r')
            result += c == '\n' ? "\r\n" : std::string(1, c);
    return result;
}

std::string compose(std::string const& base, std::string const& patch)
{
    std::size_t const second_line = patch.find('\n') + 1;
    std::string const verdict = patch.substr(0, second_line);
    std::string const whole = verdict + testat::patch_definitions(base, patch.substr(second_line));
    bool const crlf = verdict.size() > 1 && verdict[verdict.size() - 2] == '\r';
    return crlf ? with_crlf(whole) : whole;
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4)
        return std::fputs("usage: compose_upload BASE PATCH OUT\n", stderr), 2;
    try {
        std::string const whole = compose(read(argv[1]), read(argv[2]));
        std::ofstream out(argv[3], std::ios::binary);
        out << whole;
        if (!out.flush())
            throw std::runtime_error(std::string(argv[3]) + ": cannot be written");
        return 0;
    } catch (std::exception const& e) {
        return std::fprintf(stderr, "compose_upload: %s\n", e.what()), 1;
    }
}
