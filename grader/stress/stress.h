#pragma once
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"
#include "stress/tally.h"

#include <filesystem>

/// `testat stress`: millions of questions to the functions of one file, judged by the oracles of the unit checks.
namespace testat {
struct StressOptions {
    std::uint64_t seed = 1;
    std::uint32_t questions = 0;  ///< to each cheap function, fewer to others; 0: `most_questions`
    bool contract_only = false;   ///< nothing outside of the contract is asked
};

struct FunctionStress {
    Function function{};
    bool written = false;  ///< defined, and no longer the template's; else it is not asked
    Tally inside;          ///< inputs that the contract allows
    Tally outside;         ///< others, only counted
    double median = 0;     ///< of inside.errors, as those that follow; NaN if there are none
    double p999 = 0;       ///< 99.9 % are no larger
    double max = 0;
};

/// One for each of the eleven, in the order of the sheet; the same for the same build and seed whatever the number of
/// threads, unless something runs into the time limit. Throws std::runtime_error when something of ours fails.
std::vector<FunctionStress> stress(Build const& build, StressOptions const& options, Installation const& where,
                                   Cage& cage);

/// The questions of one block, as `stress` asks them.
Block stress_block(Subject const& subject, bool inside, std::uint32_t index, std::uint32_t questions,
                   std::uint64_t seed);

/// Sorts errors and fills in median, p999 and max.
void summarize(FunctionStress& result);
}  // namespace testat
