#include "checks/races.h"

#include "answers.h"
#include "checks/remarks.h"
#include "checks/textures.h"

#include <utility>

namespace testat {
namespace {
constexpr std::uint32_t several = 4;  ///< threads

/// Between them they call every function that is called while pixels are rendered. As the framework numbers filters.
constexpr std::uint32_t nearest = 0;
constexpr std::uint32_t trilinear = 2;
constexpr std::pair<std::uint32_t, Wrap> modes[] = {{trilinear, Wrap::repeat}, {nearest, Wrap::clamp}};

using Threads = std::vector<std::uint32_t>;

/// With one thread second, so that the several begin with nothing computed yet.
Threads const raced{several, 1, several, several, several, several};
Threads const not_raced{1, 1};
constexpr std::uint32_t single = 1;  ///< index of the rendering with one thread, in both

char const threads_name[] = "threads";
char const once_name[] = "threads/one";
char const once_filled_name[] = "threads/one_filled";

Group rendering_group(std::string const& name, FunctionSet from_upload, Threads const& threads)
{
    std::vector<RenderingQuestion> questions;
    for (auto const& [filter, wrap] : modes)
        for (std::uint32_t count : threads)
            questions.push_back({static_cast<std::uint32_t>(TestTexture::noise_square), filter,
                                 static_cast<std::uint32_t>(wrap), count});
    Group group = make_group(Kind::rendering, questions);
    group.name = name;
    group.from_upload = from_upload;
    return group;
}

std::string alone_name(Function function)
{
    return threads_name + ("/" + std::string(info(function).name));
}

std::uint32_t renderings_each(Answers const& answers)
{
    return answers.group.count / std::uint32_t(std::size(modes));
}

/// Whether all renderings of a mode are the same.
bool all_same(Answers const& answers)
{
    std::uint32_t const each = renderings_each(answers);
    for (std::uint32_t i = 0; i < answers.group.count; ++i)
        if (!same_words(answers, i, answers, i / each * each + single))
            return false;
    return true;
}

/// Time that is up says nothing: more is rendered here than with one thread alone.
bool may_race(Answers const* answers)
{
    if (answers == nullptr)
        return false;
    Ended const ended = answers->status.ended;
    if (ended == Ended::lost || ended == Ended::not_loaded || ended == Ended::timed_out)
        return false;
    return ended != Ended::answered || !all_same(*answers);
}

/// Whether the renderings with one thread are those of `once`.
bool same_singles(Answers const& answers, Answers const& once)
{
    for (std::uint32_t mode = 0; mode < std::size(modes); ++mode)
        if (!same_words(once, mode * renderings_each(once) + single, answers, mode * renderings_each(answers) + single))
            return false;
    return true;
}

/// Whether with one thread all goes well, whatever came before and whatever memory holds.
bool is_steady_alone(Observations const& differences)
{
    Answers const* const once = differences.find(once_name);
    Answers const* const filled = differences.find(once_filled_name);
    for (auto const* answers : {once, filled})
        if (answers == nullptr || answers->status.ended != Ended::answered || !all_same(*answers))
            return false;
    Answers const* const threads = differences.find(threads_name);
    return same_singles(*filled, *once) && (threads->status.ended != Ended::answered || same_singles(*threads, *once));
}

std::vector<Function> racing_alone(Observations const& differences)
{
    std::vector<Function> found;
    for (Function f : every_function())
        if (may_race(differences.find(alone_name(f))))
            found.push_back(f);
    return found;
}

Remark races()
{
    return {"races",
            {},
            {"Mit mehreren Threads geht es anders aus als mit einem, jedes Mal verschieden: Mehrere Aufrufe benutzen "
             "gleichzeitig dieselbe Variable (static, global), und mindestens einer schreibt.",
             "With several threads it ends differently than with one, and differently each time: several calls use the "
             "same variable (static, global) at once, and at least one writes to it."}};
}
}  // namespace

void ask_about_races(Request& request, FunctionSet well_behaved, FunctionSet writing)
{
    if (writing == FunctionSet())
        return;
    for (Function f : every_function())
        if (writing.has(f))
            request.groups.push_back(rendering_group(alone_name(f), FunctionSet::only(f), raced));
    request.groups.push_back(rendering_group(threads_name, well_behaved, raced));
    for (auto const& [name, fill] : {std::pair(once_name, usual_fill), {once_filled_name, other_fill}}) {
        request.groups.push_back(rendering_group(name, well_behaved, not_raced));
        request.groups.back().fill = fill;
    }
}

std::optional<Remark> find_races(Observations const& observations)
{
    if (!may_race(observations.find(threads_name)) || !is_steady_alone(observations))
        return std::nullopt;
    Remark remark = races();
    remark.functions = racing_alone(observations);
    return remark;
}
}  // namespace testat
