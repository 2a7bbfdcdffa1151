#include "stress/stress.h"

#include "observe/observe.h"
#include "progress.h"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <map>
#include <mutex>

namespace testat {
namespace {
/// A block is asked again so many times behind questions that ended the process, then in so many parts at once: rare
/// crashes are all counted, frequent ones do not take forever.
constexpr int most_rounds = 4;
constexpr std::size_t parts = 64;
/// So many times a block may run into the time limit, which is shorter from the second time on.
constexpr std::uint64_t most_timeouts = 3;
/// Loops that take one step for each unit of a coordinate stay below. CPU seconds.
constexpr Limits limits{5, 1, 20, 20};
/// What lies outside of the contract is one eighth of the questions.
constexpr std::uint32_t outside_share = 8;

/// Blocks of one function, all inside or all outside of its contract.
struct Series {
    Subject const* subject;
    bool inside;
    std::uint32_t questions;
    std::vector<Tally> tallies;  ///< one for each block

    std::uint32_t questions_in(std::size_t block) const
    {
        return std::min(subject->block, questions - static_cast<std::uint32_t>(block) * subject->block);
    }
    bool hangs() const { return tallies.front().counts.timed_out > 0; }
};

struct Job {
    Series* series;
    std::size_t block;
};

/// `count` questions of a group.
Group part_of(Group const& group, std::uint32_t first, std::uint32_t count)
{
    Group part = group;
    std::size_t const size = question_bytes(group.kind);
    auto const begin = group.questions.begin() + static_cast<std::ptrdiff_t>(first * size);
    part.questions.assign(begin, begin + static_cast<std::ptrdiff_t>(count * size));
    part.count = count;
    return part;
}

std::vector<Group> split(std::vector<Group> const& groups, std::size_t into)
{
    std::vector<Group> all;
    for (auto const& group : groups) {
        auto const each = static_cast<std::uint32_t>((group.count - 1) * groups.size() / into + 1);
        for (std::uint32_t first = 0; first < group.count; first += each) {
            all.push_back(part_of(group, first, std::min(each, group.count - first)));
            all.back().name += fmt::format("/{}", first);
        }
    }
    return all;
}

std::uint64_t count_questions(std::vector<Group> const& groups)
{
    std::uint64_t count = 0;
    for (auto const& group : groups)
        count += group.count;
    return count;
}

/// A group whose turn did not come, because others had used up the time.
bool was_left_out(GroupStatus const& status)
{
    return status.ended == Ended::timed_out && status.answered == 0 && status.cpu_s == 0;
}

void count_end(Ended ended, Counts& counts)
{
    switch (ended) {
        case Ended::exception:
            ++counts.exceptions;
            return;
        case Ended::timed_out:
            ++counts.timed_out;
            return;
        default:
            ++counts.crashed;
    }
}

/// Asks a block, and again what lies behind questions that ended the process.
class Asking {
public:
    Asking(Build const& build, Installation const& where, Cage& cage, Oracle oracle)
        : build_(build), where_(where), cage_(cage), oracle_(oracle)
    {
    }

    Tally ask(Block block)
    {
        request_.limits = limits;
        request_.textures = std::move(block.textures);
        request_.groups = {std::move(block.group)};
        Tally tally;
        tally.counts.asked = count_questions(request_.groups);
        for (int i = 0; i < most_rounds && !request_.groups.empty(); ++i)
            ask_once(tally);
        tally.counts.not_answered += count_questions(request_.groups);
        return tally;
    }

private:
    /// Leaves in the request what had better be asked again.
    void ask_once(Tally& tally)
    {
        Observations const observations = observe(build_, request_, where_, cage_);
        std::vector<Group> rest;
        for (auto const& group : request_.groups) {
            Group left = settle(observations.groups.at(group.name), tally);
            if (left.count > 0)
                rest.push_back(std::move(left));
        }
        bool const hangs = tally.counts.timed_out > 0;
        if (hangs)
            request_.limits.group_s = request_.limits.after_timeout_s;
        if (tally.counts.timed_out >= most_timeouts) {
            tally.counts.not_answered += count_questions(rest);
            rest.clear();
        }
        request_.groups = hangs ? std::move(rest) : split(rest, std::max(parts, rest.size()));
    }

    /// What is left of a group to be asked again.
    Group settle(Answers const& answers, Tally& tally) const
    {
        GroupStatus const& status = answers.status;
        Group const& group = answers.group;
        tally.add(tally_answers(answers, status.answered, request_.textures, oracle_));
        if (was_left_out(status) || status.ended == Ended::answered || status.ended == Ended::not_loaded) {
            tally.counts.not_answered += group.count - status.answered;
            return part_of(group, group.count, 0);
        }
        count_end(status.ended, tally.counts);
        std::uint32_t const done = std::min(group.count, status.answered + 1);
        return part_of(group, done, group.count - done);
    }

    Build const& build_;
    Installation const& where_;
    Cage& cage_;
    Oracle oracle_;
    Request request_;
};

Tally left_out(std::uint32_t questions)
{
    Tally tally;
    tally.counts.asked = tally.counts.not_answered = questions;
    return tally;
}

/// Functions that take longer get fewer, in proportion.
std::uint32_t questions_to(Subject const& subject, StressOptions const& options)
{
    if (options.questions == 0)
        return subject.questions;
    double const share = double(subject.questions) / most_questions;
    return std::max(1u, static_cast<std::uint32_t>(options.questions * share));
}

std::vector<Series> make_series(Build const& build, StressOptions const& options)
{
    std::vector<Series> all;
    for (auto const& subject : subjects()) {
        std::uint32_t const questions = questions_to(subject, options);
        std::uint32_t const others = options.contract_only ? 0 : std::max(1u, questions / outside_share);
        if (!build.written().has(subject.function) || build.library.empty())
            continue;
        for (auto const& [inside, count] : {std::pair(true, questions), std::pair(false, others)})
            if (count > 0)
                all.push_back({&subject, inside, count, std::vector<Tally>((count - 1) / subject.block + 1)});
    }
    return all;
}

Tally ask_block(Job const& job, Build const& build, StressOptions const& options, Installation const& where, Cage& cage)
{
    Series const& series = *job.series;
    std::uint32_t const questions = series.questions_in(job.block);
    if (job.block > 0 && series.hangs())
        return left_out(questions);
    Oracle const oracle = series.inside ? series.subject->oracle : nullptr;
    auto const index = static_cast<std::uint32_t>(job.block);
    return Asking(build, where, cage, oracle)
        .ask(stress_block(*series.subject, series.inside, index, questions, options.seed));
}

/// Says when all blocks of a series are done, from any thread.
class SeriesProgress {
public:
    explicit SeriesProgress(std::size_t series) : progress_("Stress", series) {}

    void block_is_done(Series const& series)
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        if (++done_[&series] == series.tallies.size())
            progress_.step(std::string(info(series.subject->function).name) + (series.inside ? "" : " (outside)"));
    }

private:
    std::mutex mutex_;
    std::map<Series const*, std::size_t> done_;
    Progress progress_;
};

/// The first block of a series tells whether the function hangs; then the others are left out.
void run(std::vector<Series>& all, Build const& build, StressOptions const& options, Installation const& where,
         Cage& cage)
{
    std::vector<Job> first, rest;
    for (auto& series : all)
        for (std::size_t block = 0; block < series.tallies.size(); ++block)
            (block == 0 ? first : rest).push_back({&series, block});
    SeriesProgress progress(all.size());
    for (auto const& jobs : {first, rest})
        tbb::parallel_for_each(jobs, [&](Job const& job) {
            job.series->tallies[job.block] = ask_block(job, build, options, where, cage);
            progress.block_is_done(*job.series);
        });
}

/// The smallest error that `share` of all are not above. Sorted; not empty.
double quantile(std::vector<float> const& errors, double share)
{
    auto const rank = static_cast<std::size_t>(std::ceil(share * double(errors.size())));
    return errors[std::max<std::size_t>(rank, 1) - 1];
}
}  // namespace

Block stress_block(Subject const& subject, bool inside, std::uint32_t index, std::uint32_t questions,
                   std::uint64_t seed)
{
    std::string const name =
        fmt::format("stress/{}/{}/{}", info(subject.function).name, inside ? "inside" : "outside", index);
    Random random(seed, name);
    Block block = (inside ? subject.inside : subject.outside)(random, questions);
    block.group.name = name;
    block.group.under_test = subject.function;
    block.group.from_upload = FunctionSet::only(subject.function);
    return block;
}

void summarize(FunctionStress& result)
{
    auto& errors = result.inside.errors;
    std::sort(errors.begin(), errors.end());
    result.median = result.p999 = result.max = NAN;
    if (errors.empty())
        return;
    result.median = quantile(errors, 0.5);
    result.p999 = quantile(errors, 0.999);
    result.max = errors.back();
}

std::vector<FunctionStress> stress(Build const& build, StressOptions const& options, Installation const& where,
                                   Cage& cage)
{
    std::vector<Series> all = make_series(build, options);
    run(all, build, options, where, cage);
    std::vector<FunctionStress> results;
    for (auto const& subject : subjects()) {
        FunctionStress result;
        result.function = subject.function;
        for (auto& series : all) {
            if (series.subject != &subject)
                continue;
            result.written = true;
            for (auto const& tally : series.tallies)
                (series.inside ? result.inside : result.outside).add(tally);
        }
        summarize(result);
        results.push_back(std::move(result));
    }
    return results;
}
}  // namespace testat
