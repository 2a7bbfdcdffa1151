#pragma once
#include "process/run.h"
#include "report/report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace testat {
/// What the verdict on a file depends on, besides its bytes: whatever makes results of before worthless.
struct GradingBasis {
    std::string programs;  ///< SHA-256 of judge, probe, framework, reference libraries and envelopes
    std::string rubric;    ///< ... of rubric.json
    std::string compiler;  ///< name and version
    std::uint64_t seed = 1;
    bool lenient = false;

    /// Names it: 64 hexadecimal digits.
    std::string key() const;
};

/// Of the installation as it is now. Reads some 20 MB. Throws std::runtime_error if a part is missing.
GradingBasis current_basis(std::string const& compiler, std::uint64_t seed, bool lenient);

/// Results of a batch by content: a folder for each file and basis, which appears as a whole or not at all.
///   <root>/results/<key>/report.json, pictures/    <root>/work/...: under way
class Store {
public:
    /// Makes the folders, and takes away what an interrupted batch has left under way. Throws std::runtime_error if
    /// another batch works there.
    explicit Store(std::filesystem::path root);

    /// SHA-256 of the file and basis together.
    static std::string key(std::filesystem::path const& file, GradingBasis const& basis);

    std::filesystem::path folder(std::string const& key) const { return root_ / "results" / key; }

    /// Whatever lies there when a batch is killed is taken away by the next one.
    std::filesystem::path work() const { return root_ / "work"; }

    /// The report kept for it, if one is there and says "graded".
    std::optional<Report> find(std::string const& key) const;

    /// A new folder to grade into.
    std::filesystem::path begin(std::string const& key) const;

    /// Makes what was graded into begin()'s folder the result.
    void keep(std::string const& key) const;

private:
    std::filesystem::path root_;
    Descriptor lock_;
};
}  // namespace testat
