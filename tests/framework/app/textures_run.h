#pragma once

#include "temporary_directory.h"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

inline std::string contents(std::string const& path)
{
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

/// A program that has run in a folder of its own.
class TexturesRun {
public:
    /// The launcher is a command that runs the program given behind it.
    explicit TexturesRun(std::string const& program, std::string const& launcher = "")
        : command_(launcher + "'" + program + "' ")
    {
    }

    int exit_code(std::string const& arguments)
    {
        std::string const command = "cd '" + directory.path() + "' && " + command_ + arguments + " > out 2> err";
        int const status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::string out() const { return contents(directory.path("out")); }
    std::string err() const { return contents(directory.path("err")); }
    std::string image(std::string const& name) const { return directory.path("assignment_images/" + name + ".png"); }

    int num_images() const
    {
        auto const files = std::filesystem::directory_iterator(directory.path("assignment_images"));
        return int(std::distance(begin(files), end(files)));
    }

    TemporaryDirectory directory;

private:
    std::string command_;
};
