#pragma once
#include "checks/check.h"

/// What is right: one oracle for each function, for every question that the function's contract allows. The unit checks
/// and `testat stress` share them.
namespace testat {
/// How far the answer to a question is off, in units of its bound.
using Oracle = Deviation (*)(Answers const& answers, std::uint32_t index, Textures const& textures, Words words);

Deviation nearest_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation wrap_clamp_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation wrap_repeat_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation bilinear_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation mipmap_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation footprint_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation trilinear_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation direction_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation position_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation intersect_deviation(Answers const&, std::uint32_t index, Textures const&, Words);
Deviation tangent_space_deviation(Answers const&, std::uint32_t index, Textures const&, Words);

/// A judge for unit checks that puts every question to the oracle.
inline auto judge_by(Oracle oracle)
{
    return [oracle](Answers const& answers, Textures const& textures) {
        Verdict verdict;
        for (std::uint32_t i = 0; i < answers.group.count; ++i)
            verdict.offer(i, oracle(answers, i, textures, Words::for_mistakes));
        return verdict;
    };
}
}  // namespace testat
