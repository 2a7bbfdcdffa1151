#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

/// Processes of this machine, as tests look for them.
namespace testat {
struct Process {
    pid_t pid = 0;
    pid_t parent = 0;
    std::string name;  ///< the kernel's, of 15 letters at most
};

/// All that come from a process; what ends meanwhile may be left out.
std::vector<Process> descendants(pid_t ancestor);

/// The same once an upload runs: the probe's server, its child, and whatever is around them. Empty if that does not
/// come to pass within a minute.
std::vector<Process> wait_for_upload(pid_t program);
}  // namespace testat
