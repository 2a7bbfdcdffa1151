#include "sandbox/slot.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace testat {
namespace {
constexpr char directory[] = "/run/testat";

/// Ours alone: whoever could write there could keep all slots taken.
Descriptor open_directory()
{
    if (mkdir(directory, 0700) != 0 && errno != EEXIST)
        throw std::runtime_error(std::string("cannot make ") + directory);
    Descriptor opened(open(directory, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat status = {};
    if (opened.get() < 0 || fstat(opened.get(), &status) != 0 || status.st_uid != 0 || (status.st_mode & 0022) != 0)
        throw std::runtime_error(std::string(directory) + " must be a folder of root that nobody else writes to");
    return opened;
}

Descriptor lock_file(int folder, uid_t uid)
{
    std::string const name = "slot-" + std::to_string(uid);
    Descriptor file(openat(folder, name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (file.get() < 0)
        throw std::runtime_error("cannot write " + (std::string(directory) + "/").append(name));
    return file;
}
}  // namespace

Slot::Slot()
{
    if (geteuid() != 0)
        return;
    Descriptor const folder = open_directory();
    for (uid_t uid = first_slot_uid; uid < first_slot_uid + slots; ++uid) {
        Descriptor file = lock_file(folder.get(), uid);
        if (flock(file.get(), LOCK_EX | LOCK_NB) == 0) {
            uid_ = uid;
            lock_ = std::move(file);
            return;
        }
    }
    throw std::runtime_error("all users for uploads are taken; are there hundreds of graders running?");
}
}  // namespace testat
