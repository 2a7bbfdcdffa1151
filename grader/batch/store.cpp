#include "batch/store.h"

#include "installation.h"
#include "text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace testat {
namespace {
std::string bytes_of(fs::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in)
        throw std::runtime_error("cannot read " + file.string());
    return bytes;
}

/// Made at build time, and large: their names, sizes and times stand for them.
std::string envelopes_state(fs::path const& folder)
{
    std::vector<std::string> lines;
    for (auto const& entry : fs::directory_iterator(folder))
        lines.push_back(fmt::format("{} {} {}\n", entry.path().filename().string(), entry.file_size(),
                                    entry.last_write_time().time_since_epoch().count()));
    std::sort(lines.begin(), lines.end());
    std::string all;
    for (auto const& line : lines)
        all += line;
    return all;
}

std::string programs_state(Installation const& where)
{
    std::string all;
    for (auto const& file : {fs::path("/proc/self/exe"), where.libraries / "probe", where.libraries / "confine",
                             where.libraries / "libtestat_framework.so", where.libraries / "libtestat_trampolines.so",
                             where.references / "all.so", where.exercise_template})
        all += sha256(bytes_of(file));
    return sha256(all + envelopes_state(where.envelopes));
}

std::string version_of(std::string const& compiler)
{
    std::string const text = run({{compiler, "--version"}, "/", {}, 10, 30}).output;
    return text.substr(0, text.find('\n'));
}
}  // namespace

std::string GradingBasis::key() const
{
    return sha256(fmt::format("{}\n{}\n{}\n{}\n{}\n", programs, rubric, compiler, seed, lenient));
}

GradingBasis current_basis(std::string const& compiler, std::uint64_t seed, bool lenient)
{
    auto const& where = installation();
    return {programs_state(where), sha256(bytes_of(where.rubric)), version_of(compiler), seed, lenient};
}

Store::Store(fs::path root) : root_(std::move(root))
{
    fs::create_directories(root_ / "results");
    lock_ = Descriptor(open((root_ / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (lock_.get() < 0)
        throw std::runtime_error("cannot write to " + root_.string());
    if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0)
        throw std::runtime_error("another batch works in " + root_.parent_path().string());
    fs::remove_all(work());
    fs::create_directories(work());
}

std::string Store::key(fs::path const& file, GradingBasis const& basis)
{
    return sha256(sha256(bytes_of(file)) + basis.key());
}

std::optional<Report> Store::find(std::string const& key) const
{
    auto const file = folder(key) / "report.json";
    if (!fs::exists(file))
        return std::nullopt;
    try {
        std::ifstream in(file);
        Report report = Report::parse(in);
        return report.at("status") == "graded" ? std::optional(std::move(report)) : std::nullopt;
    } catch (Report::exception const&) {
        return std::nullopt;  // damaged: it is graded again
    }
}

fs::path Store::begin(std::string const& key) const
{
    fs::path folder = work() / key;
    fs::remove_all(folder);
    return folder;
}

void Store::keep(std::string const& key) const
{
    fs::remove_all(folder(key));
    fs::rename(work() / key, folder(key));
}
}  // namespace testat
