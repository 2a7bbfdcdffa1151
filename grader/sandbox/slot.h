#pragma once
#include "process/run.h"

#include <sys/types.h>

namespace testat {
/// A user that nobody else is, while this object lives. The kernel counts processes for each user and lets a user
/// signal and trace what is its own; so of graders that run side by side as root, each gives its uploads a user of
/// their own. For a grader that is not root there is only the one user that it is.
class Slot {
public:
    /// Takes the first one free. Throws std::runtime_error if all are taken or the locks cannot be written.
    Slot();

    /// 0 stands for the user that this program is.
    uid_t uid() const { return uid_; }

private:
    uid_t uid_ = 0;
    Descriptor lock_;
};

/// Users of slots: [first_slot_uid, first_slot_uid + slots), which Debian and systemd give to nobody.
constexpr uid_t first_slot_uid = 60578;
constexpr uid_t slots = 512;
}  // namespace testat
