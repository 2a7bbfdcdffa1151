#pragma once
#include "installation.h"
#include "report/report.h"
#include "report/text.h"

#include <filesystem>
#include <string>

/// `testat theory ANSWERS.json`: the sheet's two theory questions as a self-check. There are no points.
///
///   {"transformation": {"M": rows, "factors": [...]},
///    "barycentric": {"areas": {"F1": formula, ...}, "lambda": {"A": formula, ...}, "P'": formula or {"u": ..., "v":
///    ...}}}
///
/// read_factors (matrices.h) and Expression (expression.h) say what may stand there; "explanation" is never read.
namespace testat::theory {
constexpr std::size_t largest_answers = 1 << 20;  ///< bytes
constexpr int deepest_answers = 16;               ///< lists and objects within each other

/// Reads a file of answers. Throws std::invalid_argument, naming file and place, for what is no JSON object.
Report read_answers(std::filesystem::path const& file);

/// The same of its bytes; `name` is how the file is called in messages.
Report parse_answers(std::string const& bytes, std::string const& name);

/// Judges all answers, whatever they are:
///   {"answers": [{"question": "transformation", "id": "M", "verdict": "right" | "wrong" | "unreadable" | "unanswered",
///                 "answer": as read, "findings": [{"id", "de", "en"}]}, ...],
///    "right": N, "asked": N, "not_read": ["names that have no meaning", ...]}
Report judge(Report const& answers);

/// A judgement for people: what is right in a table, then each answer that is not, with what is wrong about it. `file`
/// is the base name. 80 columns.
std::string to_text(Report const& judged, std::string const& file, Language language);

/// A file of answers to be filled in, with explanations. Throws std::runtime_error if the installation lacks it.
std::string answers_template(Language language, Installation const& where);
}  // namespace testat::theory
