#include "observe/observe.h"

#include "process/run.h"
#include "text.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
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
    if (!(std::abs(status.kept) < 1e12))
        status.kept = 0;
    return status;
}

Answers lost(Group const& group)
{
    return {group, GroupStatus{}, std::vector<std::uint32_t>(group.answer_size(), unanswered)};
}

/// M_PERTURB leaves out what malloc keeps in its cache.
char const fill_every_block[] = "GLIBC_TUNABLES=glibc.malloc.tcache_count=0";

std::string ask(Build const& build, std::vector<std::byte> const& questions, Descriptor const& answers,
                Limits const& limits, Installation const& where)
{
    Descriptor const request = memory_file("request");
    write_all(request.get(), questions.data(), questions.size());
    Finished const probe = run({{(where.libraries / "probe").string(), build.library.string(),
                                 where.references.string(), where.assets.string()},
                                "/",
                                {{request.get(), 3}, {answers.get(), 4}},
                                0,
                                4 * limits.total_s + 60,
                                0,
                                0,
                                {fill_every_block}});
    return clean_text(probe.output, 400);
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

Observations observe(Build const& build, Request const& request, Installation const& where)
{
    auto const start = std::chrono::steady_clock::now();
    Descriptor const answers = memory_file("answers");
    std::string const complaint = ask(build, serialize(request), answers, request.limits, where);
    auto const stream = read_stream(answers.get(), stream_size(request));
    if (stream.size() < sizeof greeting)
        throw std::runtime_error("the probe did not start: " + complaint);
    Observations observations = decode_answers(request, stream);
    observations.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return observations;
}
}  // namespace testat
