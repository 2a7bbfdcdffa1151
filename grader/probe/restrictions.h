#pragma once
#include <linux/filter.h>

#include <string>
#include <vector>

namespace testat {
/// What a child may not do: prepared once by the server, put in force by each child, for ever.
///   before the upload is loaded, whose constructors run then: of files, to read the upload only (Landlock); no
///   process,
///     no socket, no memory file, no signal to others, no code but what is in that file: a list of the few system calls
///     that computing needs
///   after it is loaded: no file at all. A constructor can keep this from coming into force, and gains one file by it:
///     its own
/// Threads are for the groups that ask for them. Sanitizers need much more than the list, so there nothing is refused.
class Restrictions {
public:
    /// Throws std::runtime_error if the kernel has no filters.
    explicit Restrictions(std::string upload);

    /// Throws std::system_error if the kernel refuses.
    void before_loading(bool threads) const;
    void after_loading() const;

private:
    std::string upload_;
    std::vector<sock_filter> computing_;
    std::vector<sock_filter> computing_with_threads_;
    std::vector<sock_filter> loaded_;
};
}  // namespace testat
