#pragma once
#include "end_to_end/testat_program.h"

/// What the test of the attacks and their table have in common. A file of tests/attacks holds one attack, over the
/// reference like a file of tests/submissions. What attacks stands in `#ifndef WITHOUT_ATTACK`, so that the same file
/// without it, its twin, does no harm. The first line says how the attack must end:
///   // attack: {"at": "run", "earns": [19, 19], "builds": true, "says": {"wrap_repeat": "wrong"}, "policy": []}
/// at: when it begins: "compile", "load" (constructors) or "run".
/// earns: points before policy, from and to.
/// builds: whether it compiles and links; true if it is left out.
/// says: verdicts in report.json; all others are that of "*", "correct" if that is left out, too. "any" is any.
/// policy: what of the sheet's policies applies; none if it is left out, "does_not_compile" where nothing builds.
/// In its text @UPLOAD@ stands for the folder it lies in, @NEIGHBOUR@ for that of another upload, @REPOSITORY@ for the
/// sources of the grader and @BUILD@ for what is built of them: an attacker may know where everything is.
namespace testat {
struct Attack {
    std::string name;
    std::string patch;
    Json expected;
};

/// Every file of tests/attacks, by name. Throws std::runtime_error if the first line of one says nothing.
std::vector<Attack> all_attacks();

/// An attack and its twin, graded.
struct Trial {
    std::string ended = "not graded";  ///< "build error", "crashed", "timed out", "refused"
    double points = 0;
    double points_without = 0;
    double containment_s = 0;                  ///< how much longer grading took than that of the twin
    std::vector<std::string> changes = {};     ///< of the host: files, traces, memory, processes
    std::vector<std::string> complaints = {};  ///< what is not as line 1 says, what was gained, what leaked, `changes`
};

/// Grades in a folder of its own that holds secrets and files to spoil. A twin that was graded before is not graded
/// again. Makes this process the one that orphans of the grader belong to, and waits for all its children.
Trial try_attack(Attack const& attack);

/// The report of tests/submissions/example.cpp, but for what takes time.
Json grade_next_upload();
}  // namespace testat
