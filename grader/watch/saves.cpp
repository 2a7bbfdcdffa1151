#include "watch/saves.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace testat {
namespace {
constexpr double look_again_s = 0.03;

std::filesystem::path folder_of(std::filesystem::path const& file)
{
    auto folder = std::filesystem::absolute(file).parent_path();
    if (!std::filesystem::is_directory(folder))
        throw std::invalid_argument(folder.string() + ": there is no such folder");
    return folder;
}

Descriptor watch_folder(std::filesystem::path const& folder)
{
    Descriptor inotify(inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
    std::uint32_t const events = IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
    if (inotify.get() < 0 || inotify_add_watch(inotify.get(), folder.c_str(), events) < 0)
        throw std::system_error(errno, std::generic_category(), "watching " + folder.string());
    return inotify;
}
}  // namespace

Saves::Saves(std::filesystem::path const& file)
    : file_(std::filesystem::absolute(file)), inotify_(watch_folder(folder_of(file)))
{
}

void Saves::wait()
{
    bool saved = false;
    for (;;) {
        bool const again = happened();
        saved = saved || again;
        if (saved && !again && std::filesystem::is_regular_file(file_))
            return;
        wait_for(look_again_s);
    }
}

bool Saves::happened()
{
    bool saved = false;
    alignas(inotify_event) char events[16384];
    for (;;) {
        ssize_t const size = read(inotify_.get(), events, sizeof events);
        if (size <= 0)
            return saved;
        saved = read_events(events, std::size_t(size)) || saved;
    }
}

bool Saves::read_events(char const* events, std::size_t size) const
{
    bool saved = false;
    inotify_event event{};
    for (std::size_t at = 0; at + sizeof event <= size; at += sizeof event + event.len) {
        std::memcpy(&event, events + at, sizeof event);
        if ((event.mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED)) != 0)
            throw std::runtime_error(file_.parent_path().string() + ": this folder is gone");
        bool const lost_some = (event.mask & IN_Q_OVERFLOW) != 0;
        saved = saved || lost_some || (event.len > 0 && file_.filename() == events + at + sizeof event);
    }
    return saved;
}
}  // namespace testat
