#pragma once
#include "bench/bench.h"
#include "report/text.h"

#include <filesystem>

/// `testat bench [FILE]` from the file to what is written.
namespace testat::bench {
struct BenchFile {
    std::filesystem::path file;  ///< empty: without an upload
    std::filesystem::path out;
    BenchOptions bench;
    Language language = Language::en;
    std::string compiler = "g++";
    Confinement confinement = Confinement::cage;
};

/// Writes bench.json and bench.svg into `out`, and returns what people read. That the file does not compile is among
/// the results. Throws UnreadableInput, std::invalid_argument for an `out` that cannot be written to, Interrupted, and
/// std::runtime_error when something of ours fails.
std::string bench_file(BenchFile const& options, Installation const& where);
}  // namespace testat::bench
