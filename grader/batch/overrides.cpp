#include "batch/overrides.h"

#include "json_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace testat {
namespace {
std::string text(nlohmann::json const& entry, char const* key, std::string const& place)
{
    if (!entry.contains(key) || !entry.at(key).is_string() || entry.at(key).get<std::string>().empty())
        throw BadJson(fmt::format("{}: '{}' must be a text that is not empty", place, key));
    return entry.at(key);
}

Override read_override(nlohmann::json const& entry, std::string const& place)
{
    if (!entry.is_object())
        throw BadJson(place + ": must be an object");
    if (!entry.contains("points") || !entry.at("points").is_number() || !(entry.at("points").get<double>() >= 0))
        throw BadJson(place + ": 'points' must be a number from 0 on");
    return {text(entry, "student", place), text(entry, "function", place), entry.at("points"),
            text(entry, "reason", place),  text(entry, "who", place),      text(entry, "when", place)};
}

Report note(Override const& given, double before)
{
    return {{"points_before", before}, {"reason", given.reason}, {"who", given.who}, {"when", given.when}};
}

void require_at_most(Override const& given, double max)
{
    if (!(given.points <= max))
        throw std::invalid_argument(fmt::format("overrides: {} of {} cannot have {} points; there are {}",
                                                given.function, given.student, given.points, max));
}

/// A function's points, and with it its task's and the sum.
void change_function(Report& report, Override const& given)
{
    if (!report.at("functions").contains(given.function))
        throw std::invalid_argument(
            fmt::format("overrides: {} of {}: there is no such function", given.function, given.student));
    auto& function = report.at("functions").at(given.function);
    require_at_most(given, function.at("max"));
    double const before = function.at("earned");
    double const more = given.points - before;
    function["earned"] = given.points;
    function["override"] = note(given, before);
    for (auto& task : report.at("tasks"))
        if (task.at("id") == function.at("task"))
            task["earned"] = task.at("earned").get<double>() + more;
    auto& policy = report.at("policy");
    policy["earned_without"] = policy.at("earned_without").get<double>() + more;
    if (policy.at("applied").empty())
        report["points"]["earned"] = policy.at("earned_without");
}

void change_total(Report& report, Override const& given)
{
    auto& points = report.at("points");
    require_at_most(given, points.at("max"));
    points["override"] = note(given, points.at("earned"));
    points["earned"] = given.points;
}
}  // namespace

std::vector<Override> read_overrides(std::filesystem::path const& file)
{
    std::vector<Override> all;
    if (!std::filesystem::exists(file))
        return all;
    auto const document = read_json(file);
    if (!document.is_array())
        throw BadJson(file.string() + ": must be a list");
    for (std::size_t i = 0; i < document.size(); ++i)
        all.push_back(read_override(document[i], fmt::format("{}: entry {}", file.string(), i + 1)));
    return all;
}

Report apply(std::vector<Override> const& overrides, std::vector<std::string> const& names, Report report)
{
    if (report.at("status") != "graded")
        return report;
    constexpr double pass_fraction = 0.6;
    for (bool const total : {false, true})
        for (auto const& given : overrides)
            if (std::find(names.begin(), names.end(), given.student) != names.end() &&
                (given.function == "total") == total)
                total ? change_total(report, given) : change_function(report, given);
    auto& points = report.at("points");
    points["passed_60_percent"] = points.at("earned").get<double>() >= pass_fraction * points.at("max").get<double>();
    return report;
}
}  // namespace testat
