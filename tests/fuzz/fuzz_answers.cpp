// What the probe sends: any bytes give every group an answer of the right size and a status in range, or an error.
#include "observe/observe.h"
#include "text.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace {
using namespace testat;

Request two_groups()
{
    Request request;
    for (char const* name : {"first", "second"}) {
        Group group;
        group.name = name;
        group.kind = Kind::wrap;
        group.count = 3;
        group.words_per_answer = 2;
        group.questions.resize(3 * question_bytes(Kind::wrap));
        request.groups.push_back(group);
    }
    return request;
}

void require(bool holds)
{
    if (!holds)
        std::abort();
}

void require_sense(Answers const& answers)
{
    require(answers.words.size() == answers.group.answer_size());
    require(answers.status.ended < Ended::count && answers.status.answered <= answers.group.count);
    require(answers.status.cpu_s >= 0 && answers.status.work_s <= answers.status.cpu_s);
    require(std::isfinite(answers.status.kept));
    require(clean_text(answers.status.text).size() <= 3 * sizeof answers.status.text);
    require(clean_text(answers.status.output).size() <= 3 * sizeof answers.status.output);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    static Request const request = two_groups();
    auto const* bytes = reinterpret_cast<std::byte const*>(data);
    std::vector<std::byte> stream(sizeof greeting);
    std::memcpy(stream.data(), &greeting, sizeof greeting);
    stream.insert(stream.end(), bytes, bytes + size);
    Observations const observations = decode_answers(request, stream);
    require(observations.groups.size() == request.groups.size());
    for (auto const& [name, answers] : observations.groups)
        require_sense(answers);
    try {
        decode_answers(request, {bytes, bytes + size});
        parse_request({bytes, bytes + size});
    } catch (std::runtime_error const&) {  // as they say
    }
    return 0;
}
