#pragma once
#include "probe/restrictions.h"
#include "probe/server.h"
#include "process/run.h"

namespace testat {
/// How far a child has come. Written by the child, so it can be forged; it only chooses the words of a report.
enum class Phase : std::uint32_t { starting, loading, running, threw, not_loaded, done };

/// Head of the memory that server and child share; the answer words follow it.
struct Blackboard {
    Phase phase = Phase::starting;
    std::uint32_t answered = 0;
    std::uint32_t wrote = 0;  ///< 1 if answering has changed static or global variables of the upload
    double work_s = 0;        ///< CPU time of answering
    double kept = 0;          ///< bytes on the heap that asking a second time has left behind
    double pass_s = 0;        ///< CPU time of the fastest pass
    char text[256] = {};      ///< what() of an exception; empty if it has none
};

struct ChildTask {
    Group const& group;
    std::vector<TextureData> const& textures;
    AssetLibrary& assets;
    Libraries const& libraries;
    Restrictions const& restrictions;
    double cpu_s;
    int output;  ///< takes stdout and stderr
    Blackboard& board;
    std::uint32_t* answers;
};

/// Whether a process can be restricted here, said in a process that is good for nothing else. Throws std::system_error
/// if there can be no process.
bool can_be_restricted(Restrictions const& restrictions);

/// Turns a freshly forked process into the child of a group. Does not come back.
[[noreturn]] void become_child(ChildTask const& task);
}  // namespace testat
