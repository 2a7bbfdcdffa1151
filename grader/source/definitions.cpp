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
        for (std::size_t i = 0; i < tokens_.size(); ++i)
            if (is(i, '{') || is(i, ';') || is(i, '}'))
                stops_.push_back(i);
        stops_.push_back(tokens_.size());
    }

    std::vector<Definition> definitions()
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (auto const found = head(i)) {
                std::size_t const last = closing_[found->body];
                found_.push_back(define(begin, *found, last));
                i = last;
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
            if (auto const torn = torn_head(i)) {
                begin = add_up_to_next(begin, *torn);
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

    Extent declaration_at(int line)
    {
        for (std::size_t i = 0; i < tokens_.size();) {
            if (std::size_t const brace = opens_namespace(i); brace > i) {
                i = brace + 1;
                continue;
            }
            std::size_t const last = last_of_declaration(i);
            bool const behind = line_of(tokens_[i].begin) > line;
            if (!behind && line <= line_of(tokens_[last].end))
                return {tokens_[i].begin, tokens_[last].end};
            i = last + 1;
        }
        return {};
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

    /// The brace of a namespace that begins with token i; i itself if none does.
    std::size_t opens_namespace(std::size_t i) const
    {
        std::size_t brace = i;
        if (word(i) == "namespace")
            while (brace + 1 < tokens_.size() && (tokens_[brace + 1].identifier || is(brace + 1, ':')))
                ++brace;
        return word(i) == "namespace" && is(brace + 1, '{') ? brace + 1 : i;
    }

    /// Of the declaration that begins with token i: its semicolon, or the brace that closes it.
    std::size_t last_of_declaration(std::size_t i) const
    {
        for (; i + 1 < tokens_.size() && !is(i, ';') && !is(i, '}'); ++i) {
            if (is(i, '('))
                i = closing_[i];
            if (is(i, '{'))
                return closing_[i] + (is(closing_[i] + 1, ';') ? 1 : 0);
        }
        return std::min(i, tokens_.size() - 1);
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
        std::size_t body;  ///< token of the opening brace
    };

    /// Which of the eleven is defined, declared or called with the name that is token i.
    std::optional<Function> named_before_parenthesis(std::size_t i) const
    {
        return tokens_[i].identifier && is(i + 1, '(') ? named(i) : std::nullopt;
    }

    /// The first token from i on that is no word such as const, noexcept or override.
    std::size_t first_behind_words(std::size_t i) const
    {
        while (i < tokens_.size() && tokens_[i].identifier)
            ++i;
        return i;
    }

    /// What is defined under the name that is token i.
    std::optional<Head> head(std::size_t i) const
    {
        auto const function = named_before_parenthesis(i);
        if (!function)
            return std::nullopt;
        std::size_t const body = first_behind_words(closing_[i + 1] + 1);
        if (!is(body, '{'))
            return std::nullopt;
        return Head{*function, body};
    }

    /// The same where a parenthesis or the brace may be missing, or a semicolon stands before the brace: `body` is then
    /// the last token that can belong to the head.
    std::optional<Head> torn_head(std::size_t i) const
    {
        if (auto const whole = head(i))
            return whole;
        auto const function = named_before_parenthesis(i);
        if (!function)
            return std::nullopt;
        if (std::size_t const behind = first_behind_words(closing_[i + 1] + 1); is(behind, ';'))
            return is(behind + 1, '{') ? std::optional(Head{*function, behind + 1}) : std::nullopt;
        std::size_t const stop = *std::lower_bound(stops_.begin(), stops_.end(), i);
        if (stop == tokens_.size() || is(stop, '}'))
            return std::nullopt;
        return Head{*function, is(stop, '{') ? stop : std::min(stop, closing_[i + 1])};
    }

    Definition define(std::size_t begin, Head const& head, std::size_t last)
    {
        std::size_t const start = tokens_[begin].begin;
        return {head.function, start, tokens_[head.body].begin, tokens_[last].end, line_of(start)};
    }

    /// Adds the definition, up to where another one begins in it; gives the first token behind it. Nothing that
    /// compiles has a qualified definition in a function, but a class there may have members of any name.
    std::size_t add_up_to_next(std::size_t begin, Head const& head)
    {
        std::size_t const last = is(head.body, '{') ? closing_[head.body] : head.body;
        std::size_t end = last + 1;
        for (std::size_t next = head.body + 1; next < last && end > last; ++next) {
            auto const inner = this->head(next);
            if (inner && (!matched_[head.body] || is_member(inner->function)))
                end = begin_of_statement(next, head.body);
        }
        found_.push_back(define(begin, head, end - 1));
        found_.back().closed = end > last;
        if (end > last && is(head.body, '{') && !matched_[head.body])
            found_.back().end = text_.size();
        return end;
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
    std::vector<bool> matched_;       ///< parentheses and braces that have a partner
    std::vector<std::size_t> stops_;  ///< braces and semicolons, and the end of all tokens
    std::size_t counted_ = 0;         ///< how far lines are counted
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

Extent find_declaration(std::string_view text, int line)
{
    return Parser(text).declaration_at(line);
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
