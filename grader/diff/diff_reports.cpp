#include "diff/diff.h"

#include "report/printer.h"

#include <map>

namespace testat {
namespace {
constexpr Term same{"gleich, von den Zeiten abgesehen", "the same, apart from times"};
constexpr Term total{"Punkte", "points"};
constexpr Term passed{"besteht", "passes"};
constexpr Term failed{"besteht nicht", "fails"};
constexpr Term not_asked{"nicht gefragt", "not asked"};
constexpr Term other{"sonst verschieden", "different otherwise"};

Report without_times(Report report)
{
    report.erase("timing");
    report.erase("run_time");
    return report;
}

class ReportDifference : Printer {
public:
    ReportDifference(Report const& a, Report const& b, Language language) : Printer(language), a_(a), b_(b) {}

    Difference print()
    {
        bool const equal = without_times(a_) == without_times(b_);
        if (equal)
            line("{}", say(same));
        else if (a_.at("status") != b_.at("status"))
            changed("status", text(a_.at("status")), text(b_.at("status")));
        else if (a_.at("status") == "graded")
            graded();
        if (!equal && out_.empty())
            line("{}", say(other));
        return {equal, std::move(out_)};
    }

private:
    void changed(std::string const& what, std::string const& from, std::string const& to)
    {
        if (from != to)
            line("{:<40}{} -> {}", what, from, to);
    }

    static std::string points(Report const& function)
    {
        return fmt::format("{:.2f} {}", function.at("earned").get<double>(), text(function.at("verdict")));
    }

    void graded()
    {
        auto const all = [](Report const& r) {
            return fmt::format("{:.2f} / {:.2f}", r.at("points").at("earned").get<double>(),
                               r.at("points").at("max").get<double>());
        };
        changed(say(total), all(a_), all(b_));
        for (auto const& [name, function] : a_.at("functions").items())
            if (b_.at("functions").contains(name))
                compare(name, function, b_.at("functions").at(name));
        pictures();
    }

    void compare(std::string const& name, Report const& a, Report const& b)
    {
        changed(name, points(a), points(b));
        auto const words_of = [&](Report const& function) {
            std::map<std::string, std::string> words;
            for (auto const& check : function.at("checks"))
                words[text(check.at("name"))] = say(check.at("passed").get<bool>() ? passed : failed);
            return words;
        };
        auto const before = words_of(a);
        auto const after = words_of(b);
        for (auto const& [check, word] : before)
            changed("  " + check, word, after.count(check) > 0 ? after.at(check) : say(not_asked));
        for (auto const& [check, word] : after)
            if (before.count(check) == 0)
                changed("  " + check, say(not_asked), word);
    }

    void pictures()
    {
        std::map<std::string, std::string> before;
        for (auto const& picture : a_.at("pictures"))
            before[text(picture.at("name"))] = picture.at("outside").dump();
        for (auto const& picture : b_.at("pictures"))
            if (auto const found = before.find(text(picture.at("name"))); found != before.end())
                changed(found->first, found->second + " px", picture.at("outside").dump() + " px");
    }

    Report const& a_;
    Report const& b_;
};
}  // namespace

Difference diff_reports(Report const& a, Report const& b, Language language)
{
    return ReportDifference(a, b, language).print();
}
}  // namespace testat
