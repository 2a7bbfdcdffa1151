#pragma once
#include "batch/intake.h"
#include "report/text.h"

#include <string>
#include <vector>

namespace testat {
/// Two uploads that have much in common. That accuses nobody: there are few ways to write a short function.
struct SimilarPair {
    std::string first;
    std::string second;
    int percent = 0;       ///< of the tokens of one that are found in the other, whichever has more; names do not count
    std::string passages;  ///< what they have in common, side by side; only of the first `shown_pairs`
};
constexpr std::size_t shown_pairs = 40;

/// Pairs of uploads, at least one of them of `uploads`, that share `least_percent` or more once the lines of the
/// template have been taken out; most alike first. `earlier`: those of another year. Runs sim_c++ of Debian's
/// similarity-tester, in a cage. Throws std::runtime_error if it is not installed or fails.
std::vector<SimilarPair> find_similar(std::vector<Upload> const& uploads, std::vector<Upload> const& earlier);

/// The text without the lines that the template has, too, white space aside.
std::string without_template(std::string const& text, std::string const& exercise_template);

/// A list for people.
std::string similarity_to_text(std::vector<SimilarPair> const& pairs, Language language);
}  // namespace testat
