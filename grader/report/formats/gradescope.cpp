#include "report/formats/format.h"

#include "report/reading.h"

namespace testat {
namespace {
constexpr Term build_failed{"Die Datei lässt sich nicht übersetzen oder binden", "The file does not compile or link"};
constexpr Term by_hand{"Von Hand geändert", "Changed by hand"};
constexpr Term not_gradable{"Nicht bewertbar; das liegt nicht an der Abgabe", "Not gradable; not the upload's fault"};

std::string output_of(Report const& report, Language language)
{
    std::string text;
    if (!report.at("build").at("ok").get<bool>())
        text = say(build_failed, language);
    for (auto const& diagnostic : report.at("build").at("diagnostics"))
        text +=
            fmt::format("\n{}:{}: {}: {}", diagnostic.at("file").get<std::string>(), diagnostic.at("line").get<int>(),
                        diagnostic.at("severity").get<std::string>(), diagnostic.at("message").get<std::string>());
    for (auto const& change : Reading(report).by_hand())
        text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", say(by_hand, language), change);
    return text;
}

Report test_of(Report const& report, std::string const& name, Language language)
{
    Report const& function = report.at("functions").at(name);
    return {{"name", name},
            {"name_format", "text"},
            {"score", function.at("earned")},
            {"max_score", function.at("max")},
            {"status", function.at("earned") == function.at("max") ? "passed" : "failed"},
            {"output", explain_function(report, name, language)},
            {"output_format", "text"},
            {"tags", Report::array({function.at("task")})},
            {"visibility", "visible"}};
}
}  // namespace

std::string to_gradescope(std::vector<NamedReport> const& reports, Language language)
{
    Report const& report = reports.at(0).report;
    Report document = {{"output_format", "text"}, {"visibility", "visible"}, {"stdout_visibility", "hidden"}};
    document["extra_data"] = {{"submission", report.at("submission")}, {"test_set", report.at("test_set")}};
    if (report.at("status") != "graded") {
        document["output"] = fmt::format("{}: {}", say(not_gradable, language), report.at("error").get<std::string>());
        document["tests"] = Report::array();
        return to_text(document);
    }
    document["score"] = report.at("points").at("earned");
    document["execution_time"] = report.at("timing").at("total_ms").get<double>() / 1e3;
    document["output"] = output_of(report, language);
    document["tests"] = Report::array();
    for (auto const& entry : report.at("functions").items())
        document["tests"].push_back(test_of(report, entry.key(), language));
    return to_text(document);
}
}  // namespace testat
