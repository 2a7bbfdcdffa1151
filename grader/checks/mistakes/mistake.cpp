#include "checks/mistakes/mistake.h"

#include <algorithm>

namespace testat {
namespace {
/// What was asked of a function by its unit checks.
std::vector<Answers const*> answers_of(Function function, CheckResults const& results, Observations const& observations)
{
    std::vector<Answers const*> found;
    for (auto const& check : results.checks) {
        Answers const* const answers = observations.find(check.name);
        if (check.function == function && answers != nullptr)
            found.push_back(answers);
    }
    return found;
}

bool explains_end(Model const& model, Answers const& answers, Textures const& textures)
{
    auto const& status = answers.status;
    if (status.ended == Ended::answered)
        return true;
    bool const died = status.ended == Ended::signal || status.ended == Ended::exception;  // at() throws
    return died && status.answered < answers.group.count && model.may_crash &&
           model.may_crash(answers.group, status.answered, textures);
}

bool explains(Model const& model, Answers const& answers, Textures const& textures)
{
    if (!explains_end(model, answers, textures))
        return false;
    std::uint32_t const answered = std::min(answers.status.answered, answers.group.count);
    for (std::uint32_t i = 0; i < answered; ++i)
        if (!model.explains(answers, i, textures))
            return false;
    return true;
}

bool explains_all(Mistake const& mistake, std::vector<Answers const*> const& asked, Textures const& textures)
{
    return std::any_of(mistake.models.begin(), mistake.models.end(), [&](Model const& model) {
        return std::all_of(asked.begin(), asked.end(),
                           [&](Answers const* answers) { return explains(model, *answers, textures); });
    });
}

/// Nothing if no mistake explains the answers, or more than one.
std::optional<std::string> name_mistake(Function function, std::vector<Answers const*> const& asked,
                                        Textures const& textures)
{
    std::optional<std::string> name;
    for (auto const& mistake : mistakes()) {
        if (mistake.function != function || !explains_all(mistake, asked, textures))
            continue;
        if (name)
            return std::nullopt;
        name = mistake.id;
    }
    return name;
}
}  // namespace

std::map<Function, std::string> name_mistakes(CheckResults const& results, Observations const& observations,
                                              Textures const& textures)
{
    std::map<Function, std::string> names;
    for (Function function : every_function()) {
        auto const asked = answers_of(function, results, observations);
        if (asked.empty() || results.passing().has(function))
            continue;
        if (auto const name = name_mistake(function, asked, textures))
            names[function] = *name;
    }
    return names;
}

std::vector<Mistake> const& mistakes()
{
    static std::vector<Mistake> const all = [] {
        std::vector<Mistake> mistakes;
        add_evaluate_nearest_mistakes(mistakes);
        add_wrap_mistakes(mistakes);
        add_evaluate_bilinear_mistakes(mistakes);
        add_create_mipmap_mistakes(mistakes);
        add_compute_uv_aabb_size_mistakes(mistakes);
        add_evaluate_trilinear_mistakes(mistakes);
        add_transform_mistakes(mistakes);
        add_intersect_mistakes(mistakes);
        add_tangent_space_mistakes(mistakes);
        return mistakes;
    }();
    return all;
}
}  // namespace testat
