#include "theory/tokens.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace testat::theory {
namespace {
bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// What people write instead of what a keyboard has.
struct Spelling {
    std::string_view written;
    std::string_view means;
};
constexpr Spelling letters[] = {{"λ", "lambda"}, {"π", "pi"}};
constexpr Spelling primes[] = {{"'", "'"}, {"′", "'"}, {"’", "'"}};
constexpr Spelling signs[] = {{"−", "-"}, {"–", "-"}, {"·", "·"}, {"⋅", "·"}, {"×", "×"}, {"°", "°"}};

class Lexer {
public:
    explicit Lexer(std::string_view text) : rest_(text) {}

    std::vector<Token> all()
    {
        std::vector<Token> tokens;
        do
            tokens.push_back(next());
        while (tokens.back().kind != Token::Kind::end);
        return tokens;
    }

private:
    Token next()
    {
        while (!rest_.empty() && std::string_view(" \t\n\r").find(rest_[0]) != std::string_view::npos)
            skip(1);
        Token token;
        token.place = place_;
        if (rest_.empty())
            return token;
        if (read_number(token) || read_name(token) || read_sign(token))
            return token;
        throw refused_at(place_, {fmt::format("„{}“ gehört in keine Formel", unknown()),
                                  fmt::format("'{}' is no part of a formula", unknown())});
    }

    /// The first character that nobody knows.
    std::string unknown() const
    {
        std::size_t length = 1;
        while (length < rest_.size() && (rest_[length] & 0xc0) == 0x80)
            ++length;
        return one_line(rest_.substr(0, length));
    }

    void skip(std::size_t bytes)
    {
        auto const is_first = [](char c) { return (c & 0xc0) != 0x80; };
        place_ += std::size_t(std::count_if(rest_.begin(), rest_.begin() + std::ptrdiff_t(bytes), is_first));
        rest_.remove_prefix(bytes);
    }

    /// Appends what is meant by the spelling at the front, if there is one of the table.
    template <std::size_t size>
    bool take(Spelling const (&table)[size], std::string& meaning)
    {
        for (auto const& spelling : table)
            if (rest_.substr(0, spelling.written.size()) == spelling.written) {
                meaning += spelling.means;
                skip(spelling.written.size());
                return true;
            }
        return false;
    }

    bool read_number(Token& token)
    {
        constexpr std::string_view half = "½";
        if (rest_.substr(0, half.size()) == half)
            return found_number(token, 0.5, half.size());
        if (!is_digit(rest_[0]) && !(rest_[0] == '.' && rest_.size() > 1 && is_digit(rest_[1])))
            return false;
        double number = 0;
        auto const [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        if (error != std::errc())
            throw refused_at(place_, {"diese Zahl ist zu groß oder zu klein", "this number is too large or too small"});
        return found_number(token, number, std::size_t(end - rest_.data()));
    }

    bool found_number(Token& token, double number, std::size_t bytes)
    {
        token.kind = Token::Kind::number;
        token.number = number;
        skip(bytes);
        return true;
    }

    bool read_name(Token& token)
    {
        while (!rest_.empty() && read_letter(token.text, !token.text.empty())) {
        }
        if (token.text.empty())
            return false;
        take(primes, token.text);
        token.kind = Token::Kind::name;
        return true;
    }

    bool read_letter(std::string& name, bool digits_too)
    {
        if (take(letters, name))
            return true;
        if (!is_letter(rest_[0]) && !(digits_too && is_digit(rest_[0])))
            return false;
        name += rest_[0];
        skip(1);
        return true;
    }

    bool read_sign(Token& token)
    {
        token.kind = Token::Kind::sign;
        if (take(signs, token.text))
            return true;
        if (std::string_view("+-*/^(),|.").find(rest_[0]) == std::string_view::npos)
            return false;
        token.text = rest_[0];
        skip(1);
        return true;
    }

    std::string_view rest_;
    std::size_t place_ = 1;
};
}  // namespace

Refused refused_at(std::size_t place, Phrase const& why)
{
    return {{fmt::format("Beim {}. Zeichen: {}.", place, why.de), fmt::format("At character {}: {}.", place, why.en)}};
}

std::vector<Token> tokens_of(std::string_view text)
{
    return Lexer(text).all();
}
}  // namespace testat::theory
