#pragma once
#include "functions.h"
#include "protocol/request.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What flows through the pipeline: plain records, one for each arrow of DESIGN.md.
///   Submission -> Build -> Observations -> CheckResults -> Report
namespace testat {
/// A sentence for students, in both languages.
struct Phrase {
    std::string de;
    std::string en;
};

/// The file as it was handed in.
struct Submission {
    std::string file;                    ///< base name
    std::string text;                    ///< empty if `refused`
    std::string sha256;                  ///< of the file's bytes, hexadecimal; empty above 256 MB
    std::optional<std::string> refused;  ///< why it cannot be a C++ file at all: empty, binary, too large
};

/// One message of the compiler or linker, or of ours in the same form.
struct Diagnostic {
    std::string file;  ///< base name; empty for the linker
    int line = 0;      ///< from 1; 0 if it belongs to no line
    int column = 0;
    std::string severity;  ///< "error", "fatal error", "warning" or "note"
    std::string message;
};

/// Where a function stands in the upload.
struct SourceExcerpt {
    int line = 0;
    std::string text;
};

struct Build {
    bool ok = false;       ///< compiles and links as the sheet demands
    std::string compiler;  ///< name and version
    std::vector<Diagnostic> diagnostics;
    std::filesystem::path library;  ///< empty if there is nothing to load
    FunctionSet defined;            ///< functions that the library defines
    std::map<Function, SourceExcerpt> sources;
    double ms = 0;
};

/// What the probe saw of one group. `words` are hostile until a check has looked at them.
struct Answers {
    Group group;
    GroupStatus status;
    std::vector<std::uint32_t> words;
};

/// By name of the group.
struct Observations {
    std::map<std::string, Answers> groups;
    double ms = 0;
};

/// Failure of a check in the words of a report.
struct Mismatch {
    std::string input;     ///< the question
    std::string measured;  ///< what came back
    std::string expected;  ///< what would have been right; for tutors only
};

struct CheckResult {
    std::string name;  ///< "EvaluateNearest.NegativeCoordinates"
    Function function{};
    bool passed = false;
    Ended ended = Ended::answered;
    std::string detail;             ///< for tutors
    std::optional<Phrase> trouble;  ///< crash, time-out, exception, exit or printing, told to students
    std::optional<Mismatch> mismatch;
};

/// RGB floats, row 0 at the bottom.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;
};

struct PictureResult {
    std::string name;
    std::vector<Function> functions;
    std::size_t outside = 0;  ///< pixels outside the envelope, isolated
    std::size_t limit = 0;    ///< pixels that may lie outside
    double score = 0;         ///< 0 to 1
    double rms = 0;           ///< of the isolated picture, linear units
    double max_error = 0;
    std::size_t submitted_outside = 0;
    Ended isolated_ended = Ended::answered;
    Ended submitted_ended = Ended::answered;
    bool submitted_asked = false;  ///< not if the file does not link
    std::optional<Picture> isolated;
    std::optional<Picture> submitted;
    Picture expected;
    std::vector<std::string> explained_by;  ///< functions whose replacement by the reference repairs the picture
    double ms = 0;
    double reference_ms = 0;
};

struct CheckResults {
    std::vector<CheckResult> checks;
    std::vector<PictureResult> pictures;
    double ms = 0;
};

enum class FunctionVerdict { correct, partial, wrong, missing, crashed, timed_out };

/// What a function earns, and why.
struct FunctionGrade {
    Function function{};
    double unit = 0;     ///< weighted share of its unit checks that pass; 0 if an essential one fails
    double picture = 0;  ///< mean over its pictures
    double earned = 0;   ///< max * min(unit, (1 + picture) / 2), rounded half up
    double max = 0;
    FunctionVerdict verdict = FunctionVerdict::wrong;
};

/// What the file earns.
struct Grade {
    std::vector<FunctionGrade> functions;  ///< as in the rubric
    double earned = 0;                     ///< after policy
    double earned_without = 0;             ///< the sum of the functions
    double max = 0;
    bool passed = false;                ///< earned >= pass_fraction * max
    std::vector<std::string> policies;  ///< that apply to this file; with `lenient` none does
};
}  // namespace testat
