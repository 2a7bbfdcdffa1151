#include "source/definitions.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace testat {
namespace {
struct Token {
    std::size_t begin;
    std::size_t end;
    bool identifier;
};

bool starts_name(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool continues_name(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_raw_prefix(std::string_view name)
{
    return name == "R" || name == "LR" || name == "uR" || name == "UR" || name == "u8R";
}

/// Cuts text into identifiers and single characters; everything else is skipped.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens()
    {
        while (at_ < text_.size())
            step();
        return std::move(tokens_);
    }

private:
    bool looking_at(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

    void step()
    {
        char const c = text_[at_];
        if (c == '\n' || std::isspace(static_cast<unsigned char>(c)) != 0)
            skip_space(c);
        else if (looking_at("//"))
            skip_line();
        else if (looking_at("/*"))
            skip_behind("*/", at_ + 2);
        else if (c == '#' && line_start_)
            skip_directive();
        else
            significant(c);
    }

    void significant(char c)
    {
        line_start_ = false;
        if (c == '"' || c == '\'')
            skip_literal(c);
        else if (starts_name(c))
            name();
        else if (std::isdigit(static_cast<unsigned char>(c)) != 0)
            skip_number();
        else
            add(at_ + 1, false);
    }

    void skip_space(char c)
    {
        line_start_ = line_start_ || c == '\n';
        ++at_;
    }

    /// To the end of the line, with continued lines.
    void skip_line()
    {
        while (at_ < text_.size() && text_[at_] != '\n')
            at_ += looking_at("\\\n") ? 2 : looking_at("\\\r\n") ? 3 : 1;
    }

    /// A preprocessor line; `#if 0` with all that it leaves out.
    void skip_directive()
    {
        bool const dead = directive() == "if" && argument() == "0";
        skip_line();
        for (int depth = dead ? 1 : 0; depth > 0 && at_ < text_.size(); skip_line())
            depth += change_of_depth(depth);
    }

    /// At the start of a line: goes to its `#` if it is a directive, and says how it changes the nesting.
    int change_of_depth(int depth)
    {
        at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
        if (at_ == text_.size() || text_[at_] != '#')
            return 0;
        auto const name = directive();
        bool const alternative = name == "else" || name == "elif";
        bool const opens = name == "if" || name == "ifdef" || name == "ifndef";
        return opens ? 1 : name == "endif" || (alternative && depth == 1) ? -1 : 0;
    }

    /// The word behind `#`, and the one behind that.
    std::string_view directive() const { return word_at(at_ + 1).first; }
    std::string_view argument() const { return word_at(word_at(at_ + 1).second).first; }

    std::pair<std::string_view, std::size_t> word_at(std::size_t from) const
    {
        while (from < text_.size() && (text_[from] == ' ' || text_[from] == '\t'))
            ++from;
        std::size_t end = from;
        while (end < text_.size() && continues_name(text_[end]))
            ++end;
        return {text_.substr(from, end - from), end};
    }

    void skip_behind(std::string_view mark, std::size_t from)
    {
        std::size_t const found = text_.find(mark, std::min(from, text_.size()));
        at_ = found == std::string_view::npos ? text_.size() : found + mark.size();
    }

    void skip_literal(char quote)
    {
        ++at_;
        while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n')
            at_ += text_[at_] == '\\' ? 2 : 1;
        at_ = std::min(at_ + 1, text_.size());
    }

    /// Digit separators look like character literals, so numbers are taken whole.
    void skip_number()
    {
        while (at_ < text_.size() && (continues_name(text_[at_]) || text_[at_] == '.' || text_[at_] == '\''))
            ++at_;
    }

    void name()
    {
        std::size_t end = at_;
        while (end < text_.size() && continues_name(text_[end]))
            ++end;
        if (end < text_.size() && text_[end] == '"' && is_raw_prefix(text_.substr(at_, end - at_)))
            return skip_raw_string(end + 1);
        add(end, true);
    }

    void skip_raw_string(std::size_t delimiter)
    {
        std::size_t const open = text_.find('(', delimiter);
        if (open == std::string_view::npos) {
            at_ = text_.size();
            return;
        }
        std::string const mark = ")" + std::string(text_.substr(delimiter, open - delimiter)) + "\"";
        skip_behind(mark, open);
    }

    void add(std::size_t end, bool identifier)
    {
        tokens_.push_back({at_, end, identifier});
        at_ = end;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    bool line_start_ = true;
    std::vector<Token> tokens_;
};

/// Recognises definitions in a list of tokens.
class Parser {
public:
    explicit Parser(std::string_view text)
        : text_(text), tokens_(Lexer(text).tokens()), closing_(tokens_.size(), tokens_.empty() ? 0 : tokens_.size() - 1)
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

    /// The definition whose name is token i, with its last token.
    std::optional<std::pair<Definition, std::size_t>> definition(std::size_t begin, std::size_t i)
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
        std::size_t const last = closing_[body];
        std::size_t const start = tokens_[begin].begin;
        return std::pair{Definition{*function, start, tokens_[body].begin, tokens_[last].end, line_of(start)}, last};
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
    std::size_t counted_ = 0;  ///< how far lines are counted
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

std::string replace_body(std::string_view text, Function function, std::string_view body)
{
    std::string result(text);
    auto const all = find_definitions(text);
    for (auto d = all.rbegin(); d != all.rend(); ++d)
        if (d->function == function)
            result.replace(d->body, d->end - d->body, body);
    return result;
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
