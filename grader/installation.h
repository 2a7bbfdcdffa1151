#pragma once
#include <filesystem>
#include <string>

namespace testat {
/// Where everything that belongs to this program lies.
struct Installation {
    std::string version;
    std::filesystem::path include;     ///< the framework's include root
    std::filesystem::path headers;     ///< precompiled headers: <compiler>/<standard>/submission.h.gch or .pch
    std::filesystem::path libraries;   ///< trampolines, framework, probe
    std::filesystem::path references;  ///< reference libraries: all.so, without_<function>.so
    std::filesystem::path assets;
    std::filesystem::path envelopes;
    std::filesystem::path exercise_template;  ///< the exercise_03.cpp that students start from
    std::filesystem::path rubric;             ///< rubric.json; its schema lies beside it
};

/// The one this executable was built for.
Installation const& installation();

/// The parts of it that are missing; empty if it is whole.
std::string missing_parts(Installation const& where);
}  // namespace testat
