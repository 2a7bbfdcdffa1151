#include "rubric/rubric.h"

#include "json_schema.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
using Json = nlohmann::json;

Phrase read_phrase(Json const& json)
{
    return {json.at("de"), json.at("en")};
}

RubricCheck read_check(Json const& json)
{
    return {json.at("name"),
            json.at("weight"),
            json.value("essential", false),
            json.at("visibility") == "public",
            read_phrase(json.at("title")),
            read_phrase(json.at("hint"))};
}

RubricFunction read_function(std::string const& name, Json const& json)
{
    auto const function = find_function(name);
    if (!function)
        throw BadRubric("rubric: '" + name + "' is no function of the sheet");
    RubricFunction result;
    result.function = *function;
    result.task = json.at("task").get<std::string>().at(0);
    result.points = json.at("points");
    result.pictures = json.at("pictures").get<std::vector<std::string>>();
    for (auto const& check : json.at("checks"))
        result.checks.push_back(read_check(check));
    for (auto const& mistake : json.value("mistakes", Json::array()))
        result.mistakes.push_back({mistake.at("id"), read_phrase(mistake.at("text"))});
    return result;
}

Policy read_policy(Json const& json)
{
    Policy policy{json.at("id"), json.at("points"), {}, read_phrase(json.at("text"))};
    if (json.contains("ends"))
        policy.ends = json.at("ends").get<std::set<std::string>>();
    return policy;
}

double total_weight(RubricFunction const& function)
{
    double sum = 0;
    for (auto const& check : function.checks)
        sum += check.weight;
    return sum;
}

void check_sense(RubricFunction const& function)
{
    auto const name = info(function.function).name;
    if (!(std::abs(total_weight(function) - 1) < 1e-9))
        throw BadRubric(fmt::format("rubric: the weights of {} add up to {}, not to 1", name, total_weight(function)));
    if (std::none_of(function.checks.begin(), function.checks.end(), [](auto const& c) { return c.essential; }))
        throw BadRubric(fmt::format("rubric: {} has no essential check", name));
}

Rubric convert(Json const& json)
{
    Rubric rubric;
    rubric.version = json.at("version");
    rubric.standard = json.at("standard");
    rubric.deadline = json.at("deadline");
    rubric.pass_fraction = json.at("pass_fraction");
    rubric.rounding = json.at("rounding");
    auto const& limits = json.at("limits");
    rubric.limits = {limits.at("group_s"), limits.at("after_timeout_s"), limits.at("total_s"), limits.at("hanging_s")};
    for (auto const& task : json.at("tasks"))
        rubric.tasks.push_back({task.at("id").get<std::string>().at(0), read_phrase(task.at("title"))});
    for (auto const& [name, function] : json.at("functions").items())
        rubric.functions.push_back(read_function(name, function));
    for (auto const& policy : json.at("policies"))
        rubric.policies.push_back(read_policy(policy));
    return rubric;
}
}  // namespace

Rubric read_rubric(std::filesystem::path const& file)
{
    Json const json = read_json(file);
    auto schema = file;
    validate_json(json, schema.replace_extension(".schema.json"), file.filename().string());
    Rubric rubric = convert(json);
    std::sort(rubric.functions.begin(), rubric.functions.end(),
              [](auto const& a, auto const& b) { return a.function < b.function; });
    if (rubric.functions.size() != function_count)
        throw BadRubric(fmt::format("rubric: {} functions, not {}", rubric.functions.size(), function_count));
    for (auto const& function : rubric.functions)
        check_sense(function);
    return rubric;
}

Rubric only_tasks(Rubric rubric, std::set<char> const& tasks)
{
    for (char task : tasks)
        if (std::none_of(rubric.tasks.begin(), rubric.tasks.end(), [&](auto const& t) { return t.id == task; }))
            throw std::invalid_argument(fmt::format("'{}' is no task of the sheet; tasks are a to f", task));
    auto const unwanted_task = [&](auto const& t) { return tasks.count(t.id) == 0; };
    auto const unwanted_function = [&](auto const& f) { return tasks.count(f.task) == 0; };
    rubric.tasks.erase(std::remove_if(rubric.tasks.begin(), rubric.tasks.end(), unwanted_task), rubric.tasks.end());
    rubric.functions.erase(std::remove_if(rubric.functions.begin(), rubric.functions.end(), unwanted_function),
                           rubric.functions.end());
    return rubric;
}

Rubric only_public(Rubric rubric)
{
    for (auto& function : rubric.functions) {
        auto& checks = function.checks;
        checks.erase(std::remove_if(checks.begin(), checks.end(), [](auto const& c) { return !c.is_public; }),
                     checks.end());
        double const total = total_weight(function);
        for (auto& check : checks)
            check.weight = total > 0 ? check.weight / total : 1.0 / double(checks.size());
    }
    return rubric;
}

std::vector<std::pair<std::string, std::vector<Function>>> pictures_of(Rubric const& rubric)
{
    std::vector<std::pair<std::string, std::vector<Function>>> all;
    for (auto const& function : rubric.functions)
        for (auto const& picture : function.pictures) {
            auto found = std::find_if(all.begin(), all.end(), [&](auto const& p) { return p.first == picture; });
            if (found == all.end())
                found = all.insert(all.end(), {picture, {}});
            found->second.push_back(function.function);
        }
    return all;
}

std::string name_of(Ended ended)
{
    constexpr char const* names[] = {"answered", "signal", "exit", "exception", "timed_out", "not_loaded", "lost"};
    return names[static_cast<std::uint32_t>(ended)];
}
}  // namespace testat
