#include "source/lexer.h"

#include <algorithm>
#include <cctype>

namespace testat {
namespace {
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

class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    Lexed lexed()
    {
        while (at_ < text_.size())
            step();
        return std::move(lexed_);
    }

private:
    /// Behind lines that are continued here: a backslash at the end of a line is as if it were not there.
    std::size_t behind_splices(std::size_t at) const
    {
        for (;;) {
            if (text_.substr(at, 2) == "\\\n")
                at += 2;
            else if (text_.substr(at, 3) == "\\\r\n")
                at += 3;
            else
                return at;
        }
    }

    bool starts_comment(char second) const
    {
        if (text_[at_] != '/')
            return false;
        std::size_t const next = behind_splices(at_ + 1);
        return next < text_.size() && text_[next] == second;
    }

    void skip_block_comment()
    {
        std::size_t at = behind_splices(at_ + 1) + 1;
        while ((at = text_.find('*', at)) != std::string_view::npos) {
            at = behind_splices(at + 1);
            if (at < text_.size() && text_[at] == '/') {
                at_ = at + 1;
                return;
            }
        }
        at_ = text_.size();
    }

    void step()
    {
        char const c = text_[at_];
        if (c == '\n' || std::isspace(static_cast<unsigned char>(c)) != 0)
            skip_space(c);
        else if (std::size_t const end = behind_splices(at_); end != at_)
            at_ = end;
        else if (starts_comment('/'))
            skip_line();
        else if (starts_comment('*'))
            skip_block_comment();
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
        while (at_ < text_.size() && text_[at_] != '\n') {
            std::size_t const end = behind_splices(at_);
            at_ = end == at_ ? at_ + 1 : end;
        }
    }

    /// A preprocessor line; `#if 0` with all that it leaves out.
    void skip_directive()
    {
        bool const dead = directive() == "if" && argument() == "0";
        if (!dead)
            note_directive();
        skip_line();
        for (int depth = dead ? 1 : 0; depth > 0 && at_ < text_.size(); skip_line())
            depth += change_of_depth(depth);
    }

    void note_directive()
    {
        auto const name = directive();
        if (name == "if" || name == "ifdef" || name == "ifndef")
            ++conditions_;
        else if (name == "endif")
            --conditions_;
        else if (name == "define" || name == "undef")
            redefined_ = true;
        else if (name == "include" && conditions_ == 0 && !redefined_)
            note_include();
    }

    /// <name> or "name"
    void note_include()
    {
        std::size_t const open = text_.find_first_not_of(" \t", word_at(at_ + 1).second);
        if (open == std::string_view::npos || (text_[open] != '<' && text_[open] != '"'))
            return;
        std::size_t const close = text_.find_first_of(text_[open] == '<' ? ">\n" : "\"\n", open + 1);
        if (close != std::string_view::npos && text_[close] != '\n')
            lexed_.includes.emplace_back(text_.substr(open + 1, close - open - 1));
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
            if (std::size_t const open = raw_string_begin(end + 1); open != std::string_view::npos)
                return skip_raw_string(end + 1, open);
        add(end, true);
    }

    /// The parenthesis behind a delimiter, which has at most 16 characters and is no sentence; or npos.
    std::size_t raw_string_begin(std::size_t delimiter) const
    {
        constexpr std::size_t longest = 16;
        std::size_t const open = text_.substr(0, delimiter + longest + 1).find('(', delimiter);
        bool const is_one =
            open != std::string_view::npos &&
            text_.substr(delimiter, open - delimiter).find_first_of(") \\\t\n\v\f\r\"") == std::string_view::npos;
        return is_one ? open : std::string_view::npos;
    }

    void skip_raw_string(std::size_t delimiter, std::size_t open)
    {
        std::string const mark = ")" + std::string(text_.substr(delimiter, open - delimiter)) + "\"";
        skip_behind(mark, open);
    }

    void add(std::size_t end, bool identifier)
    {
        lexed_.tokens.push_back({at_, end, identifier});
        at_ = end;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    bool line_start_ = true;
    int conditions_ = 0;      ///< #if that are open
    bool redefined_ = false;  ///< a macro has been defined or undefined
    Lexed lexed_;
};
}  // namespace

Lexed lex(std::string_view text)
{
    return Lexer(text).lexed();
}
}  // namespace testat
