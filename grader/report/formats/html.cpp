#include "report/formats/format.h"
#include "report/formats/html_pictures.h"
#include "report/formats/page.h"
#include "report/reading.h"
#include "text.h"

#include <algorithm>
#include <sstream>

namespace testat {
namespace {
constexpr std::size_t longest_text = 4096;
constexpr std::size_t longest_source = 16384;

constexpr char const html[] =
#include "report/formats/html.mustache.inc"
    ;
constexpr char const style[] =
#include "report/formats/html.css.inc"
    ;
constexpr char const script[] =
#include "report/formats/html.js.inc"
    ;

std::string words(Report const& value)
{
    return clean_text(value.get<std::string>(), longest_text);
}

std::string number(double value)
{
    return fmt::format("{:.2f}", value);
}

std::string number(Report const& value)
{
    return number(value.get<double>());
}

Report both(Report const& phrase)
{
    return {{"de", words(phrase.at("de"))}, {"en", words(phrase.at("en"))}};
}

Report both(Phrase const& phrase)
{
    return {{"de", phrase.de}, {"en", phrase.en}};
}

Report both(Term term)
{
    return {{"de", term.de}, {"en", term.en}};
}

/// As a shell takes it, whatever is in it.
std::string quoted(std::string const& name)
{
    auto const is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_';
    };
    if (!name.empty() && std::all_of(name.begin(), name.end(), is_plain))
        return name;
    std::string out = "'";
    for (char c : name)
        out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

Report message_view(Report const& diagnostic)
{
    std::string const severity = words(diagnostic.at("severity"));
    return {{"severity", severity},
            {"is_error", severity.find("error") != std::string::npos},
            {"message", words(diagnostic.at("message"))},
            {"place", clean_text(diagnostic_line(diagnostic), longest_text)}};
}

class ReportView {
public:
    explicit ReportView(NamedReport const& named) : named_(named), report_(named.report), reading_(named.report) {}

    Report make()
    {
        Report view{{"points", points()},
                    {"tasks", tasks()},
                    {"cards", cards(true)},
                    {"fine", cards(false)},
                    {"about", about()},
                    {"policies", policies()},
                    {"home", command("")},
                    {"remarks", remarks()},
                    {"public_only", reading_.is_public_only()},
                    {"no_sandbox", !report_.value("sandbox", true)}};
        for (char const* list : {"policies", "remarks", "cards", "fine"})
            view[std::string("has_") + list] = !view.at(list).empty();
        view["first"] = first();
        view["nothing_to_fix"] = view.at("first").is_null();
        view["broken"] = broken();
        add_pictures(view);
        view["times"] = times();
        return view;
    }

private:
    Report points() const
    {
        auto const& all = report_.at("points");
        double const max = all.at("max").get<double>();
        double const share = max > 0 ? all.at("earned").get<double>() / max : 0;
        Report view{{"earned", number(all.at("earned"))},
                    {"max", number(max)},
                    {"passed", all.at("passed_60_percent")},
                    {"percent", fmt::format("{:.1f}", 100 * std::min(1.0, share))}};
        view["by_hand"] = override_of(all);
        if (reading_.has_unofficial())
            view["unofficial"] = {{"sum", number(report_.at("unofficial").at("earned"))},
                                  {"of", number(report_.at("unofficial").at("max"))}};
        return view;
    }

    static Report override_of(Report const& place)
    {
        if (!place.contains("override"))
            return nullptr;
        auto const& override = place.at("override");
        return {{"before", number(override.at("points_before"))},
                {"reason", words(override.at("reason"))},
                {"who", words(override.at("who"))}};
    }

    Report policies() const
    {
        Report all = Report::array();
        for (auto const& policy : report_.at("policy").at("applied"))
            all.push_back({{"crashes", policy == "crashes"},
                           {"not_compiled", policy != "crashes"},
                           {"without", number(report_.at("policy").at("earned_without"))},
                           {"has_no_unofficial", !reading_.has_unofficial()}});
        return all;
    }

    Report first() const
    {
        auto const fix = reading_.first_fix();
        if (!fix)
            return nullptr;
        Report view{{"what", both(fix->what)}, {"costs", number(fix->lost)}};
        if (!fix->hint.en.empty())
            view["advice"] = both(fix->hint);
        if (!fix->function.empty())
            view["where"] = {{"function", fix->function},
                             {"line", fix->line > 0 ? Report(std::to_string(fix->line)) : Report(nullptr)}};
        return view;
    }

    Report tasks() const
    {
        Report all = Report::array();
        for (auto const& task : report_.at("tasks")) {
            Report functions = Report::array();
            for (auto const& [name, function] : report_.at("functions").items())
                if (function.at("task") == task.at("id"))
                    functions.push_back(row(name, function));
            all.push_back({{"id", words(task.at("id"))},
                           {"title", both(task.at("title"))},
                           {"earned", number(reading_.earned_in(task))},
                           {"max", number(task.at("max"))},
                           {"functions", functions}});
        }
        return all;
    }

    Report row(std::string const& name, Report const& function) const
    {
        double const max = function.at("max").get<double>();
        double const earned = reading_.earned_by(name);
        return {{"function", name},
                {"earned", number(earned)},
                {"max", number(max)},
                {"width", fmt::format("{:.1f}", max > 0 ? 100 * std::min(1.0, earned / max) : 0)},
                {"verdict", both(reading_.word_for(name))},
                {"is_whole", earned >= max},
                {"is_none", earned <= 0},
                {"is_part", earned > 0 && earned < max}};
    }

    /// Functions that lose points or say something; or the others.
    Report cards(bool with_losses) const
    {
        Report all = Report::array();
        for (auto const& [name, function] : report_.at("functions").items())
            if ((reading_.lost_by(name) > 0 || first_hint(function) != nullptr) == with_losses)
                all.push_back(card(name, function));
        return all;
    }

    Report card(std::string const& name, Report const& function) const
    {
        Report view = row(name, function);
        view["task"] = words(function.at("task"));
        view["lost"] = reading_.lost_by(name) > 0 ? Report(number(reading_.lost_by(name))) : Report(nullptr);
        view["named"] = function.contains("mistake") ? both(function.at("mistake")) : Report(nullptr);
        view["missing"] = function.at("verdict") == "missing";
        view["broken_by"] = broken_by(name);
        view["by_hand"] = override_of(function);
        view["excerpt"] = excerpt(name, function);
        view["shared"] = command(words(function.at("task")));
        add_checks(view, function);
        return view;
    }

    Report broken_by(std::string const& name) const
    {
        if (!reading_.has_unofficial() || !report_.at("unofficial").at("broken").contains(name))
            return nullptr;
        return {{"message", words(report_.at("unofficial").at("broken").at(name).at("message"))}};
    }

    void add_checks(Report& view, Report const& function) const
    {
        Report told = Report::array();
        std::size_t passed = 0;
        for (auto const& check : function.at("checks")) {
            bool const says_something = !check.at("hint").is_null();
            passed += check.at("passed").get<bool>() ? 1 : 0;
            if (says_something)
                told.push_back(check_view(check, function.at("max").get<double>()));
        }
        if (told.size() > 1)
            told[1]["begins_rest"] = true;
        view["checks"] = told;
        view["more"] = told.size() > 1 ? Report(std::to_string(told.size() - 1)) : Report(nullptr);
        view["passed"] = std::to_string(passed);
        view["asked"] = std::to_string(function.at("checks").size());
        view["pictures_only"] = told.empty() && view.at("lost") != nullptr && !view.at("missing").get<bool>() &&
                                view.at("broken_by").is_null() && reading_.was_run();
    }

    Report check_view(Report const& check, double max) const
    {
        bool const passed = check.at("passed").get<bool>();
        double const worth = check.at("weight").get<double>() * max;
        Report view{{"name", words(check.at("name"))},
                    {"hint", both(check.at("hint"))},
                    {"hidden", check.at("visibility") == "hidden"},
                    {"all_depends", !passed && check.at("essential").get<bool>()},
                    {"worth", !passed && worth > 0 ? Report(number(worth)) : Report(nullptr)}};
        auto const& worst = check.at("worst_input");
        if (!worst.is_null())
            view["tried"] = {{"input", words(worst.at("input"))}, {"measured", words(worst.at("measured"))}};
        // A check that ended before its time has measured just that.
        if (!worst.is_null() && !check.at("detail").is_null() && worst.at("measured") != check.at("detail"))
            view["expected"] = words(check.at("detail"));
        return view;
    }

    /// The function line by line, with what the compiler says beneath.
    Report excerpt(std::string const& name, Report const& function) const
    {
        auto const& source = function.at("source");
        if (source.is_null())
            return nullptr;
        Report lines = Report::array();
        std::istringstream in(clean_text(source.at("text").get<std::string>(), longest_source));
        int line = source.at("line").get<int>();
        for (std::string text; std::getline(in, text); ++line)
            lines.push_back({{"line", std::to_string(line)}, {"text", text}, {"messages", messages_on(line)}});
        return {{"label", fmt::format("{}, {}:{}", name, words(report_.at("submission").at("file")),
                                      source.at("line").get<int>())},
                {"lines", lines}};
    }

    Report messages_on(int line) const
    {
        Report all = Report::array();
        for (auto const& d : report_.at("build").at("diagnostics"))
            if (d.at("line") == line && d.at("file") == report_.at("submission").at("file"))
                all.push_back(message_view(d));
        return all;
    }

    /// What keeps the file from compiling, wherever it is.
    Report broken() const
    {
        auto const& diagnostics = report_.at("build").at("diagnostics");
        if (diagnostics.empty() && reading_.builds())
            return nullptr;
        Report messages = Report::array();
        for (auto const& d : diagnostics)
            messages.push_back(message_view(d));
        return {{"fails", !reading_.builds()},
                {"compiler_says", messages},
                {"nothing_alone", !reading_.builds() && !reading_.has_unofficial()}};
    }

    void add_pictures(Report& view) const
    {
        if (!reading_.was_run())
            return;
        Report const pictures = picture_views(named_);
        for (char const* kind : {"wrong", "right"})
            if (!pictures.at(kind).empty())
                view[std::string(kind) + "_pictures"] = {{"count", std::to_string(pictures.at(kind).size())},
                                                         {kind, pictures.at(kind)}};
    }

    Report times() const
    {
        double mine = 0;
        double reference = 0;
        Report rows = Report::array();
        for (auto const& time : report_.at("run_time")) {
            double const ms = time.at("ms").get<double>();
            double const reference_ms = time.at("reference_ms").get<double>();
            mine += ms;
            reference += reference_ms;
            rows.push_back({{"name", words(time.at("picture"))},
                            {"ms", fmt::format("{:.0f}", ms)},
                            {"reference", fmt::format("{:.0f}", reference_ms)},
                            {"factor", reference_ms > 0 ? fmt::format("{:.1f}", ms / reference_ms) : "-"}});
        }
        if (rows.empty() || reference <= 0)
            return nullptr;
        return {{"total", fmt::format("{:.1f}", mine / reference)}, {"rows", rows}};
    }

    Report remarks() const
    {
        Report all = Report::array();
        for (auto const& remark : report_.value("remarks", Report::array())) {
            Report view = both(remark);
            view["about_functions"] = join(remark.at("functions"));
            view["names_some"] = !remark.at("functions").empty();
            all.push_back(view);
        }
        return all;
    }

    /// How to see the same again at home.
    std::string command(std::string const& task) const
    {
        std::string line = "./testat grade " + quoted(words(report_.at("submission").at("file")));
        line += task.empty() ? "" : " --tasks " + quoted(task);
        if (report_.at("test_set").at("seed") != 1)
            line += " --seed " + report_.at("test_set").at("seed").dump();
        if (words(report_.at("build").at("compiler")).find("clang") != std::string::npos)
            line += " --compiler clang++";
        return line + (reading_.is_public_only() ? " --profile student" : "");
    }

    Report about() const
    {
        auto const& set = report_.at("test_set");
        return {{"sha", words(report_.at("submission").at("sha256"))},
                {"rubric", words(set.at("version"))},
                {"questions", words(set.at("sha256")).substr(0, 12)},
                {"seed", set.at("seed").dump()},
                {"compiler", words(report_.at("build").at("compiler"))}};
    }

    NamedReport const& named_;
    Report const& report_;
    Reading reading_;
};

Report view_of(NamedReport const& named, Language language)
{
    Report const& report = named.report;
    Report view{{"german", language == Language::de}, {"file", words(report.at("submission").at("file"))}};
    if (report.at("status") == "graded")
        view["graded"] = ReportView(named).make();
    else
        view["not_gradable"] = {{"error", words(report.at("error"))}};
    return view;
}
}  // namespace

std::string to_html(std::vector<NamedReport> const& reports, Language language)
{
    static Page const page(html, style, script);
    return page.render(view_of(reports.at(0), language));
}
}  // namespace testat
