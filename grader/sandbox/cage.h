#pragma once
#include "process/run.h"
#include "sandbox/slot.h"

#include <mutex>
#include <optional>

// Theory of operation. A stranger's file is dangerous twice: while it is compiled (a compiler reads any file, and can
// be made to compute for ever) and while it runs. Both happen in a cage, which is put up anew for each program:
//
//   testat --fork--> bwrap --mounts, namespaces--> confine --user, filter, limits--> g++ | nm | probe --> children
//
//   1. bwrap (bubblewrap) starts with the minimal environment of run() and makes new namespaces: no network, no other
//      process, no System V memory, no mount but what the command sees. Everything is read-only, but for the directory
//      the result goes to and a /tmp of limited size, for a compiler only. There is no /proc, and of /dev only null.
//   2. confine becomes the slot's user (slot.h; as root only), gives up new privileges, loads the filter of system
//      calls that refuses what neither compiler nor probe needs, sets the limits of the kernel, says on a pipe that the
//      cage stands, and becomes the program. Without that word nothing has run, and the failure is ours.
//   3. The probe's children restrict themselves further before they load the upload: see probe/restrictions.h.
//
// A kill ends bwrap, and with it the kernel ends every process of its namespace. CPU time, wall time and memory have
// limits for each process; CPU and wall time of all programs of one upload add up to an allowance that the cage keeps,
// and what the processes of a program use together is looked at while it runs.
// What runs inside sees its files under the paths they have outside, so that a header precompiled outside fits.
//
// Without a cage (--no-sandbox: somebody grades a file of his own) the same programs run with the same limits of time
// and memory, as the user who calls; the probe's children restrict themselves there too, but for what files they read.
namespace testat {
/// A program and the files it sees.
struct Caged {
    Command command;
    std::vector<std::filesystem::path> sees = {};  ///< with everything below; those not there are left out
    std::optional<std::filesystem::path> writes = std::nullopt;  ///< a directory
    bool temporary_files = false;                                ///< has a /tmp, of 256 MB
};

/// What all programs of one upload may use; for what is left of it, see Cage.
struct Allowance {
    double cpu_s = 60;
    double wall_s = 90;
    std::size_t memory = std::size_t(3) << 30;  ///< bytes, of all processes at one time
};

enum class Confinement { cage, none };

/// May be used by several threads at once.
class Cage {
public:
    /// Throws std::runtime_error if there is no bubblewrap, or no user for the upload.
    explicit Cage(Confinement confinement, Allowance allowance = {});

    /// As testat::run, in the cage and within what is left of the allowance; without anything left nothing runs, and
    /// that is a time-out. Throws std::runtime_error if the cage cannot be put up or somebody from outside ends it,
    /// Interrupted on Ctrl-C.
    Finished run(Caged const& caged);

    /// What is left.
    Allowance left() const;

    /// Makes a new directory of ours one that caged programs can look into, and one that they can write to.
    void show(std::filesystem::path const& directory) const;
    void hand_over(std::filesystem::path const& directory) const;

    bool is_caged() const { return slot_.has_value(); }

private:
    std::optional<Slot> slot_;
    Allowance allowance_;
    mutable std::mutex mutex_;
    double spent_cpu_s_ = 0;
    double spent_wall_s_ = 0;
};

/// Why no cage can be put up on this machine, and what to do about it; empty if one can.
struct CageTrouble {
    std::string problem;
    std::string remedy;
};
CageTrouble find_cage_trouble();

/// Where the system keeps libraries; and compilers, what they need, and headers.
std::vector<std::filesystem::path> library_directories();
std::vector<std::filesystem::path> compiler_directories();
}  // namespace testat
