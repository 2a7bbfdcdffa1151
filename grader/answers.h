#pragma once
#include "model.h"

#include <array>
#include <cstring>
#include <vector>

/// How questions are put into a group, and answers taken out of one.
namespace testat {
/// A group of `questions`.
template <typename Question>
Group make_group(Kind kind, std::vector<Question> const& questions)
{
    Group group;
    group.kind = kind;
    group.count = static_cast<std::uint32_t>(questions.size());
    group.words_per_answer = answer_words(kind);
    auto const* bytes = reinterpret_cast<std::byte const*>(questions.data());
    group.questions.assign(bytes, bytes + questions.size() * sizeof(Question));
    return group;
}

template <typename Question>
Question question(Group const& group, std::uint32_t index)
{
    Question q;
    std::memcpy(&q, group.questions.data() + index * sizeof(Question), sizeof q);
    return q;
}

/// Answer words as floats.
template <std::size_t size>
std::array<float, size> floats(Answers const& answers, std::uint32_t index, std::size_t from = 0)
{
    std::array<float, size> values;
    std::memcpy(values.data(), &answers.words[std::size_t(index) * answers.group.words_per_answer + from],
                sizeof values);
    return values;
}

inline std::int32_t integer(Answers const& answers, std::uint32_t index, std::size_t word = 0)
{
    return static_cast<std::int32_t>(answers.words[std::size_t(index) * answers.group.words_per_answer + word]);
}

/// Whether two answers have the same words, as many as the first one has.
inline bool same_words(Answers const& a, std::uint32_t index_a, Answers const& b, std::uint32_t index_b)
{
    auto const* begin_a = &a.words[std::size_t(index_a) * a.group.words_per_answer];
    auto const* begin_b = &b.words[std::size_t(index_b) * b.group.words_per_answer];
    return std::equal(begin_a, begin_a + a.group.words_per_answer, begin_b);
}
}  // namespace testat
