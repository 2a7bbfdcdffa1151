#pragma once
#include "functions.h"
#include "protocol/request.h"

#include <algorithm>
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
    FunctionSet untouched;          ///< functions whose bodies are still the template's
    std::map<Function, SourceExcerpt> sources;
    std::map<Function, Diagnostic> broken;  ///< functions that keep the file from compiling, with their first error
    std::vector<Diagnostic> left_out;       ///< first errors of other declarations that keep it from compiling
    bool mended = false;                    ///< does not compile; the library is that of the file without all these

    /// What can be called and is worth asking.
    FunctionSet written() const { return FunctionSet(defined.bits() & ~untouched.bits()); }
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

    /// Null if that group was not asked.
    Answers const* find(std::string const& name) const
    {
        auto const found = groups.find(name);
        return found == groups.end() ? nullptr : &found->second;
    }
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
    std::optional<double> error;    ///< of the answer farthest off, in units of what is allowed; if all were given
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

/// How a rendering compares with what it should show.
struct Comparison {
    std::size_t outside = 0;  ///< pixels outside the envelope
    std::size_t limit = 0;    ///< pixels that may lie outside
    double score = 0;         ///< 1 while outside <= limit, then falling with the logarithm to 0 when all are outside
    double rms = 0;           ///< over all channels, linear units; infinite if a value is not finite
    double max_error = 0;
};

/// A picture as a group of the probe has made it.
struct Rendering {
    Ended ended = Ended::lost;
    std::optional<Picture> picture;  ///< nothing unless `ended` is answered
    Comparison comparison;
};

/// What a picture says of one function.
struct IsolatedPicture {
    Function function{};
    /// The function from the upload, the others from the reference. If the picture is right with all functions that
    /// pass their unit checks from the upload, that one in the place of all theirs. Nothing where the picture need not
    /// be made: as submitted it is right, and so are the function's unit checks.
    std::optional<Rendering> rendering;
    double score = 0;  ///< 0 to 1
};

struct PictureResult {
    std::string name;
    std::vector<IsolatedPicture> isolated;  ///< one for each function whose points depend on the picture
    std::optional<Rendering> submitted;     ///< nothing if the file does not link
    /// With the functions that fail unit checks (the suspects) replaced by the reference; nothing if it was not made.
    std::optional<Rendering> without_suspects;
    Picture expected;
    std::vector<std::string> explained_by;  ///< functions whose replacement by the reference repairs the picture
    double ms = 0;                          ///< CPU time of the picture as submitted
    double reference_ms = 0;
};

inline bool is_right(std::optional<Rendering> const& rendering)
{
    return rendering && rendering->comparison.score == 1;
}

/// The function for which the picture is worst; null if no points depend on it.
inline IsolatedPicture const* worst(PictureResult const& picture)
{
    IsolatedPicture const* worst = nullptr;
    for (auto const& isolated : picture.isolated)
        if (worst == nullptr || isolated.score < worst->score)
            worst = &isolated;
    return worst;
}

/// A finding that changes no points.
struct Remark {
    std::string id;                   ///< "depends_on_earlier_calls", "differs_between_runs", "races" or "leaks"
    std::vector<Function> functions;  ///< in the order of the sheet; none if nobody can tell which
    Phrase text;
};

struct CheckResults {
    std::vector<CheckResult> checks;
    std::map<Function, std::string> mistakes;  ///< id of the one mistake that explains what a function answers
    std::vector<PictureResult> pictures;
    std::vector<Remark> remarks;

    /// The functions of which no unit check has failed.
    FunctionSet passing() const
    {
        FunctionSet all = FunctionSet::all();
        for (auto const& check : checks)
            if (!check.passed)
                all = all.without(check.function);
        return all;
    }
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
    std::vector<FunctionGrade> functions;   ///< as in the rubric
    std::vector<FunctionGrade> unofficial;  ///< what those that are not broken would earn, if the file is
    double earned = 0;                      ///< after policy
    double earned_without = 0;              ///< the sum of the functions
    double max = 0;
    bool passed = false;                ///< earned >= pass_fraction * max
    std::vector<std::string> policies;  ///< that apply to this file; with `lenient` none does
};
}  // namespace testat
