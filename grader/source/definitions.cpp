#include "source/definitions.h"

#include "source/lexer.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

namespace testat {
namespace {
/// Recognises definitions in a list of tokens.
class Parser {
public:
    explicit Parser(std::string_view text)
        : text_(text),
          tokens_(lex(text).tokens),
          closing_(tokens_.size(), tokens_.empty() ? 0 : tokens_.size() - 1),
          matched_(tokens_.size(), false)
    {
        match('(', ')');
        match('{', '}');
    }

    std::vector<Definition> definitions()
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (auto const found = definition(begin, i)) {
                found_.push_back(found->first);
                i = found->second;
                begin = i + 1;
            } else if (is(i, '{')) {
                i = closing_[i];
                begin = i + 1;
            } else if (is(i, ';')) {
                begin = i + 1;
            }
        }
        return std::move(found_);
    }

    std::vector<Definition> recovered()
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (auto found = definition(begin, i)) {
                begin = cut_at_next(i, *found);
                found_.push_back(found->first);
                i = begin - 1;
            } else if (is(i, '{')) {
                i = closing_[i];
                begin = i + 1;
            } else if (is(i, '}')) {
                take_surplus(i);
                begin = i + 1;
            } else if (is(i, ';')) {
                begin = i + 1;
            }
        }
        return std::move(found_);
    }

private:
    bool is(std::size_t i, char c) const
    {
        return i < tokens_.size() && !tokens_[i].identifier && text_[tokens_[i].begin] == c;
    }

    std::string_view word(std::size_t i) const
    {
        return text_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin);
    }

    /// For each opening parenthesis or brace the token that closes it, the last token if none does. One pass, as
    /// uploads may be nested as deeply as they like.
    void match(char open, char close)
    {
        std::vector<std::size_t> waiting;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (is(i, open)) {
                waiting.push_back(i);
            } else if (is(i, close) && !waiting.empty()) {
                closing_[waiting.back()] = i;
                matched_[i] = matched_[waiting.back()] = true;
                waiting.pop_back();
            }
        }
    }

    /// Which of the eleven is defined under the name that ends with token i: members behind their class, the others
    /// alone.
    std::optional<Function> named(std::size_t i) const
    {
        auto const function = find_function(word(i));
        bool const qualified = i >= 3 && is(i - 1, ':') && is(i - 2, ':');
        if (!function || qualified != is_member(*function))
            return std::nullopt;
        std::string const owner = qualified ? std::to_string(word(i - 3).size()) + std::string(word(i - 3)) : "";
        if (info(*function).symbol.find(owner) == std::string_view::npos)
            return std::nullopt;
        return function;
    }

    static bool is_member(Function function) { return info(function).symbol.substr(0, 3) == "_ZN"; }

    struct Head {
        Function function;
        std::size_t body;  ///< the opening brace
    };

    /// What is defined under the name that is token i.
    std::optional<Head> head(std::size_t i) const
    {
        if (!tokens_[i].identifier || !is(i + 1, '('))
            return std::nullopt;
        auto const function = named(i);
        if (!function)
            return std::nullopt;
        std::size_t body = closing_[i + 1] + 1;
        while (body < tokens_.size() && tokens_[body].identifier)
            ++body;  // const, noexcept, override
        if (!is(body, '{'))
            return std::nullopt;
        return Head{*function, body};
    }

    /// The definition whose name is token i, with its last token.
    std::optional<std::pair<Definition, std::size_t>> definition(std::size_t begin, std::size_t i)
    {
        auto const found = head(i);
        if (!found)
            return std::nullopt;
        std::size_t const last = closing_[found->body];
        std::size_t const start = tokens_[begin].begin;
        return std::pair{
            Definition{found->function, start, tokens_[found->body].begin, tokens_[last].end, line_of(start)}, last};
    }

    /// Ends the definition whose name is token i where another one begins in it; gives the first token behind it.
    /// Nothing that compiles has a qualified definition in a function, but a class there may have members of any name.
    std::size_t cut_at_next(std::size_t i, std::pair<Definition, std::size_t>& found) const
    {
        auto& [definition, last] = found;
        std::size_t const body = head(i)->body;
        for (std::size_t next = body + 1; next < last; ++next) {
            auto const inner = head(next);
            if (!inner || (matched_[body] && !is_member(inner->function)))
                continue;
            std::size_t const begin = begin_of_statement(next, body);
            definition.end = tokens_[begin - 1].end;
            definition.closed = false;
            return begin;
        }
        return last + 1;
    }

    /// The first token behind the `;` or brace before token i, but behind token `before`.
    std::size_t begin_of_statement(std::size_t i, std::size_t before) const
    {
        while (i > before + 1 && !is(i - 1, ';') && !is(i - 1, '{') && !is(i - 1, '}'))
            --i;
        return i;
    }

    /// A closing brace that closes nothing belongs to the definition before it.
    void take_surplus(std::size_t i)
    {
        if (!found_.empty() && !matched_[i])
            found_.back().end = tokens_[i].end;
    }

    /// Positions come in ascending order, so every line is counted once.
    int line_of(std::size_t position)
    {
        auto const begin = text_.begin() + std::ptrdiff_t(counted_);
        line_ += static_cast<int>(std::count(begin, text_.begin() + std::ptrdiff_t(position), '\n'));
        counted_ = position;
        return line_;
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::vector<std::size_t> closing_;
    std::vector<bool> matched_;  ///< parentheses and braces that have a partner
    std::size_t counted_ = 0;    ///< how far lines are counted
    int line_ = 1;
    std::vector<Definition> found_;
};

std::string_view between(std::string_view text, std::size_t begin, std::size_t end)
{
    return text.substr(begin, end - begin);
}
}  // namespace

std::vector<Definition> find_definitions(std::string_view text)
{
    return Parser(text).definitions();
}

std::vector<Definition> recover_definitions(std::string_view text)
{
    return Parser(text).recovered();
}

std::string replace_body(std::string_view text, Function function, std::string_view body)
{
    std::string result(text);
    auto const all = find_definitions(text);
    for (auto d = all.rbegin(); d != all.rend(); ++d)
        if (d->function == function)
            result.replace(d->body, d->end - d->body, body);
    return result;
}

namespace {
std::map<Function, std::string> bodies_without_space(std::string_view text)
{
    std::map<Function, std::string> bodies;
    for (auto const& d : find_definitions(text))
        for (char const c : between(text, d.body, d.end))
            if (std::isspace(static_cast<unsigned char>(c)) == 0)
                bodies[d.function] += c;
    return bodies;
}
}  // namespace

FunctionSet same_bodies(std::string_view text, std::string_view other)
{
    auto const bodies = bodies_without_space(text);
    FunctionSet same;
    for (auto const& [function, body] : bodies_without_space(other)) {
        auto const found = bodies.find(function);
        if (found != bodies.end() && found->second == body)
            same = same.with(function);
    }
    return same;
}

std::string patch_definitions(std::string_view base, std::string_view patch)
{
    std::string extras;
    std::string result(base);
    std::size_t copied = 0;
    for (auto const& d : find_definitions(patch)) {
        extras += between(patch, copied, d.begin);
        copied = d.end;
        auto const present = find_definitions(result);
        auto const old =
            std::find_if(present.begin(), present.end(), [&](Definition const& p) { return p.function == d.function; });
        if (old != present.end())
            result.replace(old->begin, old->end - old->begin, between(patch, d.begin, d.end));
    }
    extras += patch.substr(copied);
    auto const first = find_definitions(result);
    result.insert(first.empty() ? result.size() : first.front().begin, extras + "\n");
    return result;
}
}  // namespace testat
