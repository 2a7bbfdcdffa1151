#pragma once
#include "report/text.h"
#include "stress/stress.h"

/// `testat stress FILE` from the file to what is written.
namespace testat {
struct StressFile {
    std::filesystem::path file;
    std::filesystem::path out;
    StressOptions stress;
    Language language = Language::en;
    std::string compiler = "g++";
    Confinement confinement = Confinement::cage;
};

/// Writes stress.json and stress.svg into `out`, and returns what people read. That the file does not compile is
/// among the results. Throws UnreadableInput, std::invalid_argument for an `out` that cannot be written to,
/// Interrupted, and std::runtime_error when something of ours fails.
std::string stress_file(StressFile const& options, Installation const& where);
}  // namespace testat
