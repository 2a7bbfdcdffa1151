#pragma once
#include "process/run.h"

#include <filesystem>

namespace testat {
/// The moments at which a file is saved. Its folder is watched, not the file: many editors write another one and rename
/// it over the file, and some delete it first.
class Saves {
public:
    /// Throws std::invalid_argument if its folder is none.
    explicit Saves(std::filesystem::path const& file);

    /// Returns once the file has been saved since the last call, is there, and has been left alone for a moment. Throws
    /// Interrupted on Ctrl-C, std::runtime_error if the folder is gone.
    void wait();

private:
    bool happened();
    bool read_events(char const* events, std::size_t size) const;

    std::filesystem::path file_;
    Descriptor inotify_;
};
}  // namespace testat
