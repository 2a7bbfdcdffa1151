#include "stress/tally.h"

#include "envelopes/mip_levels.h"

#include <algorithm>

namespace testat {
namespace {
struct Oddities {
    bool nan = false;
    bool infinite = false;

    void look_at(float const* numbers, std::size_t size)
    {
        for (std::size_t i = 0; i < size; ++i) {
            nan = nan || std::isnan(numbers[i]);
            infinite = infinite || std::isinf(numbers[i]);
        }
    }
};

/// In what the answer says: not in what a miss leaves behind, nor in texels that are not there.
Oddities oddities_in(Answers const& answers, std::uint32_t index)
{
    Oddities found;
    if (answers.group.kind == Kind::wrap)
        return found;
    if (answers.group.kind == Kind::mipmap) {
        MipLevels const levels = read_mip_levels(answers, index);
        found.look_at(levels.texels.data(), levels.texels.size());
        return found;
    }
    float numbers[answer_words(Kind::intersect)] = {};
    std::size_t const words = std::min<std::size_t>(answers.group.words_per_answer, std::size(numbers));
    std::memcpy(numbers, &answers.words[index * answers.group.words_per_answer], 4 * words);
    bool const is_miss = answers.group.kind == Kind::intersect && integer(answers, index) == 0;
    std::size_t const first = answers.group.kind == Kind::intersect ? 1 : 0;
    if (!is_miss)
        found.look_at(numbers + first, words - first);
    return found;
}

void judge(std::uint32_t index, Deviation const& deviation, Tally& tally, std::uint32_t& worst_index)
{
    // Comparisons that NaN fails.
    double const error = deviation.in_bounds < HUGE_VAL ? deviation.in_bounds : HUGE_VAL;
    if (!deviation.decided && error <= 1) {
        ++tally.undecided;
        return;
    }
    tally.errors.push_back(static_cast<float>(error));
    if (error > tally.worst_error) {
        tally.worst_error = error;
        worst_index = index;
    }
}
}  // namespace

void Counts::add(Counts const& other)
{
    asked += other.asked;
    nan += other.nan;
    infinite += other.infinite;
    crashed += other.crashed;
    exceptions += other.exceptions;
    timed_out += other.timed_out;
    not_answered += other.not_answered;
}

void Tally::add(Tally const& other)
{
    counts.add(other.counts);
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
    undecided += other.undecided;
    if (other.worst_error > worst_error) {
        worst_error = other.worst_error;
        worst = other.worst;
    }
}

Tally tally_answers(Answers const& answers, std::uint32_t answered, Textures const& textures, Oracle oracle)
{
    Tally tally;
    std::uint32_t worst_index = 0;
    for (std::uint32_t i = 0; i < answered; ++i) {
        Oddities const odd = oddities_in(answers, i);
        tally.counts.nan += odd.nan ? 1 : 0;
        tally.counts.infinite += odd.infinite ? 1 : 0;
        if (oracle != nullptr)
            judge(i, oracle(answers, i, textures, Words::for_mistakes), tally, worst_index);
    }
    if (oracle != nullptr && tally.worst_error >= 0) {
        Deviation const worst = oracle(answers, worst_index, textures, Words::always);
        tally.worst = Mismatch{describe_question(answers.group, worst_index, textures), worst.measured, worst.expected};
    }
    return tally;
}
}  // namespace testat
