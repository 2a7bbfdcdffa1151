#include "observe/observe.h"

#include "process/run.h"
#include "process/tree.h"
#include "text.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <system_error>

namespace testat {
namespace {
std::size_t stream_size(Request const& request)
{
    std::size_t size = sizeof greeting;
    for (auto const& group : request.groups)
        size += sizeof(GroupStatus) + 4 * group.answer_size();
    return size;
}

std::vector<std::byte> read_stream(int fd, std::size_t most)
{
    std::vector<std::byte> stream(most);
    std::size_t done = 0;
    while (done < most) {
        ssize_t const got = pread(fd, stream.data() + done, most - done, static_cast<off_t>(done));
        if (got <= 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    stream.resize(done);
    return stream;
}

/// A status as a check may rely on it.
GroupStatus checked(GroupStatus status, Group const& group)
{
    if (status.ended >= Ended::count)
        status.ended = Ended::lost;
    status.answered = std::min(status.answered, group.count);
    if (!(status.cpu_s >= 0 && status.cpu_s < 1e6))
        status.cpu_s = 0;
    if (!(status.work_s >= 0 && status.work_s <= status.cpu_s))
        status.work_s = status.cpu_s;
    if (!(status.pass_s >= 0 && status.pass_s <= status.cpu_s))
        status.pass_s = 0;
    if (!(std::abs(status.kept) < 1e12))
        status.kept = 0;
    return status;
}

Answers lost(Group const& group)
{
    return {group, GroupStatus{}, std::vector<std::uint32_t>(group.answer_size(), unanswered)};
}

/// M_PERTURB leaves out what malloc keeps in its cache. Large blocks get large pages, if the system says in this folder
/// that it has them: a fault for every 2 MB of a texture instead of every 4 kB.
char const malloc_settings[] = "GLIBC_TUNABLES=glibc.malloc.tcache_count=0:glibc.malloc.hugetlb=1";
char const large_pages[] = "/sys/kernel/mm/transparent_hugepage";

Finished ask(Build const& build, std::vector<std::byte> const& questions, Descriptor const& answers,
             Installation const& where, Cage& cage)
{
    Descriptor const request = memory_file("request");
    write_all(request.get(), questions.data(), questions.size());
    auto const probe = where.libraries / "probe";
    Caged caged;
    caged.command.argv = {probe, build.library, where.references, where.assets};
    caged.command.descriptors = {{request.get(), 3}, {answers.get(), 4}};
    caged.command.wall_s = HUGE_VAL;
    caged.command.variables = {malloc_settings};
    caged.sees = library_directories();
    if (std::filesystem::is_directory(large_pages))
        caged.sees.emplace_back(large_pages);
    for (auto const& path : {probe, where.libraries / "libtestat_trampolines.so",
                             where.libraries / "libtestat_framework.so", where.references, where.assets, build.library})
        caged.sees.push_back(path);
    return cage.run(caged);
}

/// As far as the cage's allowance goes.
Limits within(Allowance const& left, Limits limits)
{
    constexpr double to_finish_s = 2;
    limits.all_s = left.cpu_s;
    limits.wall_s = left.wall_s - to_finish_s;
    return limits;
}

bool was_killed(Observations const& observations)
{
    return std::any_of(observations.groups.begin(), observations.groups.end(), [](auto const& group) {
        return group.second.status.ended == Ended::signal && group.second.status.code == SIGKILL;
    });
}

/// The groups that a probe did not come to before it was stopped.
void time_out_rest(Observations& observations)
{
    for (auto& [name, answers] : observations.groups)
        if (answers.status.ended == Ended::lost)
            answers.status.ended = Ended::timed_out;
}
}  // namespace

Observations decode_answers(Request const& request, std::vector<std::byte> const& stream)
{
    std::uint32_t first = 0;
    if (stream.size() >= sizeof first)
        std::memcpy(&first, stream.data(), sizeof first);
    if (first != greeting)
        throw std::runtime_error("the probe did not start");

    Observations observations;
    std::size_t at = sizeof first;
    for (auto const& group : request.groups) {
        Answers answers = lost(group);
        std::size_t const size = sizeof(GroupStatus) + 4 * group.answer_size();
        if (stream.size() - at >= size) {
            std::memcpy(&answers.status, stream.data() + at, sizeof(GroupStatus));
            std::memcpy(answers.words.data(), stream.data() + at + sizeof(GroupStatus), 4 * group.answer_size());
            answers.status = checked(answers.status, group);
            at += size;
        } else {
            at = stream.size();
        }
        observations.groups.emplace(group.name, std::move(answers));
    }
    return observations;
}

Observations observe(Build const& build, Request const& request, Installation const& where, Cage& cage)
{
    long long const kills_before = out_of_memory_kills();
    Descriptor const answers = memory_file("answers");
    Finished const probe = ask(build, serialize(request, within(cage.left(), request.limits)), answers, where, cage);
    if (probe.exit_code != 0 && !probe.timed_out)
        throw std::runtime_error("the probe failed: " + clean_text(probe.output, 400));
    if (probe.timed_out && lseek(answers.get(), 0, SEEK_END) == 0)
        write_all(answers.get(), &greeting, sizeof greeting);  // it had no time even for that
    Observations observations = decode_answers(request, read_stream(answers.get(), stream_size(request)));
    if (was_killed(observations) && out_of_memory_kills() > kills_before)
        throw std::runtime_error("this machine has too little memory: its kernel killed the upload's process");
    if (probe.timed_out)
        time_out_rest(observations);
    return observations;
}
}  // namespace testat
