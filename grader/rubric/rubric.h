#pragma once
#include "model.h"

#include <set>
#include <stdexcept>

namespace testat {
struct RubricCheck {
    std::string name;  ///< of a unit check
    double weight = 0;
    bool essential = false;
    bool is_public = false;
    Phrase title;
    Phrase hint;
};

/// What a student reads whose answers are those of a known wrong solution.
struct RubricMistake {
    std::string id;
    Phrase text;
};

struct RubricFunction {
    Function function{};
    char task = 'a';
    double points = 0;
    std::vector<std::string> pictures;
    std::vector<RubricCheck> checks;  ///< weights add up to 1
    std::vector<RubricMistake> mistakes;
};

struct RubricTask {
    char id = 'a';
    Phrase title;
};

/// What the sheet does with a whole file, whatever its functions would earn.
struct Policy {
    std::string id;              ///< "does_not_compile" or "crashes"
    double points = 0;           ///< what the file gets
    std::set<std::string> ends;  ///< "crashes": how making a picture as submitted must have ended (names of Ended)
    Phrase text;
};

/// references/rubric.json: points, weights, words and policies. Everything that a course may want to change is here.
struct Rubric {
    std::string version;
    std::string standard;  ///< of the language: "c++17"
    std::string deadline;  ///< ISO 8601
    double pass_fraction = 0.6;
    double rounding = 0.25;
    Limits limits;
    std::vector<RubricTask> tasks;
    std::vector<RubricFunction> functions;  ///< in the order of the sheet
    std::vector<Policy> policies;
};

/// Thrown when rubric.json cannot be used; our fault or the tutor's, never the student's.
struct BadRubric : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads and validates against the schema beside it, then checks what a schema cannot say: weights that add up to 1,
/// one essential check at least for each function, all eleven functions. Throws BadJson or BadRubric naming the place.
Rubric read_rubric(std::filesystem::path const& file);

/// Only these tasks. Throws std::invalid_argument for a letter that is no task.
Rubric only_tasks(Rubric rubric, std::set<char> const& tasks);

/// Only public checks; the weights of a function add up to 1 again.
Rubric only_public(Rubric rubric);

/// Every picture with the functions whose points depend on it, in the order of the sheet.
std::vector<std::pair<std::string, std::vector<Function>>> pictures_of(Rubric const& rubric);

/// The name of an end in rubrics: "signal", "exit", ...
std::string name_of(Ended ended);
}  // namespace testat
