#include "report/printer.h"
#include "report/wrap.h"
#include "theory/theory.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat::theory {
namespace {
constexpr Term of{"von", "of"};
constexpr Term answers_right{"Antworten richtig", "answers right"};
constexpr Term answer_term{"Antwort", "answer"};
constexpr Term hint{"Hinweis", "hint"};
constexpr Term not_read{"Diese Namen sind in der Vorlage nicht vorgesehen und werden nicht gelesen:",
                        "These names are not in the template and are not read:"};

Term title(std::string const& question)
{
    return question == "transformation"
               ? Term{"2 Transformationen: M von S1 nach S2", "2 Transformations: M from S1 to S2"}
               : Term{"3 Baryzentrische Koordinaten im Dreieck", "3 Barycentric coordinates in the triangle"};
}

Term name(std::string const& id)
{
    return id == "factors" ? Term{"Faktoren (Rechenweg)", "factors (calculation)"} : Term{id.c_str(), id.c_str()};
}

Term verdict(std::string const& word)
{
    if (word == "right")
        return {"richtig", "right"};
    if (word == "wrong")
        return {"falsch", "wrong"};
    return word == "unreadable" ? Term{"nicht lesbar", "cannot be read"} : Term{"offen", "not answered"};
}

class TheoryPrinter : Printer {
public:
    TheoryPrinter(Report const& judged, Language language) : Printer(language), judged_(judged) {}

    std::string print(std::string const& file)
    {
        line("{}: {} {} {} {}", file, judged_.at("right").get<int>(), say(of), judged_.at("asked").get<int>(),
             say(answers_right));
        table();
        for (auto const& answer : judged_.at("answers"))
            if (is_mistaken(answer))
                mistake(answer);
        unknown_names();
        return std::move(out_);
    }

private:
    static bool is_mistaken(Report const& answer)
    {
        return answer.at("verdict") == "wrong" || answer.at("verdict") == "unreadable";
    }

    void table()
    {
        std::string question;
        for (auto const& answer : judged_.at("answers")) {
            if (text(answer.at("question")) != question)
                line("\n{}", say(title(question = text(answer.at("question")))));
            row(answer);
        }
    }

    void row(Report const& answer)
    {
        std::string const id = text(answer.at("id"));
        std::string const word = say(verdict(text(answer.at("verdict"))));
        std::string remark;
        if (!is_mistaken(answer) && !answer.at("findings").empty())
            remark = std::string(16 - columns_of(word), ' ') + phrase(answer.at("findings").at(0));
        line("    {:<24}{}", say(name(id)), wrap_words(word, 28) + wrap_remark(remark));
    }

    /// Stands beside the verdict.
    static std::string wrap_remark(std::string const& remark)
    {
        std::size_t const blanks = std::min(remark.find_first_not_of(' '), remark.size());
        return remark.substr(0, blanks) + wrap_words(remark.substr(blanks), 44);
    }

    void mistake(Report const& answer)
    {
        line("\n{}", say(name(text(answer.at("id")))));
        if (!text(answer.at("answer")).empty())
            labelled(answer_term, text(answer.at("answer")));
        for (auto const& finding : answer.at("findings"))
            labelled(hint, phrase(finding));
    }

    void labelled(Term label, std::string const& words) { line("  {:<10}{}", say(label), wrap_words(words, 12)); }

    void unknown_names()
    {
        if (judged_.at("not_read").empty())
            return;
        line("\n{}", wrap_words(say(not_read), 0));
        for (auto const& one : judged_.at("not_read"))
            line("  {}", text(one));
    }

    Report const& judged_;
};
}  // namespace

std::string to_text(Report const& judged, std::string const& file, Language language)
{
    return TheoryPrinter(judged, language).print(file);
}
}  // namespace testat::theory
