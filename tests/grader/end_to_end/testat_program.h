#pragma once
#include "process/run.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// The built program `testat` as its users see it: arguments in; exit code, texts and report.json out.
namespace testat {
using Json = nlohmann::json;

/// A run of the program that has not been waited for.
class Running {
public:
    /// Variables are added to the caller's environment: {"LANG=de_DE.UTF-8"}.
    Running(std::vector<std::string> const& arguments, std::vector<std::string> const& variables,
            std::filesystem::path const& out, std::filesystem::path const& err);

    void send(int signal) const;
    pid_t pid() const { return pid_; }

    /// The exit code; 128 + N when signal N ended it.
    int wait() const;

private:
    pid_t pid_ = -1;
};

struct Outcome {
    int exit_code = -1;
    std::string out;  ///< stdout
    std::string err;  ///< stderr
};

Outcome run_testat(std::vector<std::string> const& arguments, std::vector<std::string> const& variables = {});

/// One `testat grade`, finished.
struct Graded : Outcome {
    Json report;  ///< null if none was written
};

/// Grades a file into `out`, in English unless `arguments` say otherwise.
Graded grade_file(std::filesystem::path const& upload, std::filesystem::path const& out,
                  std::vector<std::string> const& arguments = {});

/// The same with a text as exercise_03.cpp, in a directory that is gone afterwards.
Graded grade_text(std::string const& text, std::vector<std::string> const& arguments = {});

std::string read_file(std::filesystem::path const& file);
void write_file(std::filesystem::path const& file, std::string const& bytes);

/// references/exercise_03.cpp
std::filesystem::path reference_file();
std::string reference_text();

/// submission_template/exercise_03.cpp
std::filesystem::path template_file();

/// tests/submissions/example.cpp
std::filesystem::path example_file();

/// references/exercise_03.cpp with the functions of `patch` in place of its own.
std::string patched_reference(std::string const& patch);

/// The solution, but its wrap_clamp never comes to an end.
std::string endless_text();

/// Points of every function, verdict and unit checks that failed: what a failing test prints.
std::string function_table_of(Json const& report);

/// "g++", "clang++"
std::vector<std::string> compilers();
}  // namespace testat
