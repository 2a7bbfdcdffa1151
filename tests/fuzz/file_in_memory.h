#pragma once
#include "process/run.h"

#include <string>

/// Bytes as a file that can be opened by its path, while this lives.
class FileInMemory {
public:
    FileInMemory(std::uint8_t const* data, std::size_t size) : file_(testat::memory_file("fuzz"))
    {
        testat::write_all(file_.get(), data, size);
    }
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }

private:
    testat::Descriptor file_;
};
