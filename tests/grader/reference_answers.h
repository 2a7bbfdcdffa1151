#pragma once
#include "checks/check.h"

/// The reference, linked into this program, in the place of an upload.
namespace testat {
/// The questions of a check as the grader would ask them.
Group questions_of(UnitCheck const& check, std::uint64_t seed, Textures const& textures);

/// What the reference answers in float.
Answers reference_answers(Group const& group, Textures const& textures);

/// An answer to every question of the group, all words the same.
Answers constant_answers(Group const& group, std::uint32_t word);
}  // namespace testat
