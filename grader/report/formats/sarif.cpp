#include "report/formats/format.h"

#include <set>

namespace testat {
namespace {
constexpr char schema[] = "https://json.schemastore.org/sarif-2.1.0.json";

Report place(std::string const& file, int line, int column)
{
    Report region = {{"startLine", line}};
    if (column > 0)
        region["startColumn"] = column;
    Report physical = {{"artifactLocation", {{"uri", file}}}};
    if (line > 0)
        physical["region"] = region;
    return Report::array({{{"physicalLocation", physical}}});
}

Report result(std::string const& rule, char const* level, std::string const& text, Report const& locations)
{
    return {{"ruleId", rule}, {"level", level}, {"message", {{"text", text}}}, {"locations", locations}};
}

char const* level_of(std::string const& severity)
{
    return severity == "warning" ? "warning" : severity == "note" ? "note" : "error";
}

/// A mistake by its name, else the first check that has failed, else the function itself.
std::string rule_of(std::string const& name, Report const& function)
{
    if (function.contains("mistake"))
        return function.at("mistake").at("id");
    for (auto const& check : function.at("checks"))
        if (!check.at("passed").get<bool>())
            return check.at("name");
    return name;
}

void add_results(Report& results, NamedReport const& named, bool many, Language language)
{
    Report const& report = named.report;
    std::string const file =
        (many ? named.name + "/" : std::string()) + report.at("submission").at("file").get<std::string>();
    if (report.at("status") != "graded") {
        results.push_back(result("not_gradable", "error", report.at("error"), place(file, 0, 0)));
        return;
    }
    for (auto const& d : report.at("build").at("diagnostics"))
        results.push_back(result("compiler", level_of(d.at("severity")), d.at("message"),
                                 place(file, d.at("line").get<int>(), d.at("column").get<int>())));
    for (auto const& [name, function] : report.at("functions").items()) {
        if (function.at("verdict") == "correct" || !function.contains("source") || !function.at("source").is_object())
            continue;
        std::string const why = explain_function(report, name, language);
        results.push_back(result(rule_of(name, function), "error", why.empty() ? name : name + ": " + why,
                                 place(file, function.at("source").at("line").get<int>(), 0)));
    }
}
}  // namespace

std::string to_sarif(std::vector<NamedReport> const& reports, Language language)
{
    Report results = Report::array();
    for (auto const& named : reports)
        add_results(results, named, reports.size() > 1, language);
    Report rules = Report::array();
    std::set<std::string> known;
    for (auto const& entry : results)
        if (known.insert(entry.at("ruleId")).second)
            rules.push_back({{"id", entry.at("ruleId")}});
    Report const driver = {{"name", "Testat"}, {"rules", rules}};
    return to_text({{"$schema", schema},
                    {"version", "2.1.0"},
                    {"runs", Report::array({{{"tool", {{"driver", driver}}}, {"results", results}}})}});
}
}  // namespace testat
