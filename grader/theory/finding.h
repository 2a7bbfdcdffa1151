#pragma once
#include "model.h"

#include <string>
#include <vector>

namespace testat::theory {
/// What is to be said of an answer.
struct Finding {
    std::string id;  ///< of the mistake, "transposed"
    Phrase text;
};

enum class Verdict { right, wrong, unreadable, unanswered };

/// One answer of the sheet, judged.
struct Judgement {
    std::string id;  ///< "M", "factors", "F1", "lambda_A", "P'"
    Verdict verdict = Verdict::unanswered;
    std::string answer;             ///< as it was read: the matrix, the formula; empty if there is none
    std::vector<Finding> findings;  ///< what is wrong with it; of a right answer what else may be said
};
}  // namespace testat::theory
