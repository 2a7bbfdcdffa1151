#pragma once
#include "checks/oracles.h"
#include "checks/random.h"

#include <vector>

/// What `testat stress` asks each function. The file of a function's generators says which inputs its contract allows
/// (GRADING.md, section 5); what lies outside is asked too, but only counted.
namespace testat {
/// Questions of one kind, with the textures they are about.
struct Block {
    Textures textures;
    Group group;
};

using MakeBlock = Block (*)(Random& random, std::uint32_t questions);

struct Subject {
    Function function{};
    std::uint32_t questions = 0;  ///< asked unless the caller wants another number
    MakeBlock inside = nullptr;   ///< inputs that the contract allows
    MakeBlock outside = nullptr;
    Oracle oracle = nullptr;
    std::uint32_t block = 65'536;  ///< questions to one child process
};

/// What the cheap functions are asked.
constexpr std::uint32_t most_questions = 1 << 20;

/// All eleven, in the order of the sheet.
std::vector<Subject> const& subjects();

Block wraps_inside(Random&, std::uint32_t questions);
Block wraps_outside(Random&, std::uint32_t questions);
Block texels_inside(Random&, std::uint32_t questions);
Block lookups_inside(Random&, std::uint32_t questions);
Block lookups_outside(Random&, std::uint32_t questions);
Block filtered_inside(Random&, std::uint32_t questions);
Block filtered_outside(Random&, std::uint32_t questions);
Block mipmaps_inside(Random&, std::uint32_t questions);
Block mipmaps_outside(Random&, std::uint32_t questions);
Block footprints_inside(Random&, std::uint32_t questions);
Block footprints_outside(Random&, std::uint32_t questions);
Block directions_inside(Random&, std::uint32_t questions);
Block directions_outside(Random&, std::uint32_t questions);
Block positions_inside(Random&, std::uint32_t questions);
Block positions_outside(Random&, std::uint32_t questions);
Block hits_inside(Random&, std::uint32_t questions);
Block hits_outside(Random&, std::uint32_t questions);
Block frames_inside(Random&, std::uint32_t questions);
Block frames_outside(Random&, std::uint32_t questions);

/// A block of questions that need no textures, each made by `make(random)`.
template <typename Question, typename Make>
Block make_block(Kind kind, Random& random, std::uint32_t count, Make const& make)
{
    std::vector<Question> questions;
    questions.reserve(count);
    while (questions.size() < count)
        questions.push_back(make(random));
    return {{}, make_group(kind, questions)};
}
}  // namespace testat
