#pragma once
#include "stress/subjects.h"

#include <optional>

/// What became of the questions to one function.
namespace testat {
/// How many questions had which end.
struct Counts {
    std::uint64_t asked = 0;  ///< including those that were left out
    std::uint64_t nan = 0;    ///< answers with a NaN in it
    std::uint64_t infinite = 0;
    std::uint64_t crashed = 0;  ///< by a signal, or by ending the process
    std::uint64_t exceptions = 0;
    std::uint64_t timed_out = 0;
    std::uint64_t not_answered = 0;  ///< left out: behind too many crashes, or behind a time-out

    void add(Counts const& other);
};

struct Tally {
    Counts counts;
    /// One for each answer that can be judged, in units of the allowed bound; infinite for NaN and wrong whole numbers.
    std::vector<float> errors;
    std::uint64_t undecided = 0;  ///< answers that the bound says nothing about; not among `errors`
    double worst_error = -1;
    std::optional<Mismatch> worst;

    void add(Tally const& other);
};

/// Judges the first `answered` answers of a group. Where `oracle` is null they are only counted; `asked` is up to the
/// caller.
Tally tally_answers(Answers const& answers, std::uint32_t answered, Textures const& textures, Oracle oracle);
}  // namespace testat
