#include "batch/regrade.h"

#include "diff/diff.h"

#include <fmt/format.h>

#include <sstream>

namespace testat {
namespace {
std::string indented(std::string const& text)
{
    std::istringstream in(text);
    std::string out;
    for (std::string line; std::getline(in, line);)
        out += "    " + line + "\n";
    return out;
}
}  // namespace

Applied::Applied(std::filesystem::path file) : file_(std::move(file)), before_(read_if_there(file_)) {}

std::string Applied::changes(std::vector<GradedUpload> const& entries, std::filesystem::path const& results,
                             Language language) const
{
    std::string out;
    for (auto const& entry : entries) {
        if (!before_.contains(entry.upload.student))
            continue;
        auto const& before = before_.at(entry.upload.student);
        bool const same_file = before.at("sha256") == entry.report.at("submission").at("sha256");
        if (!same_file || before.at("points") == entry.graded)
            continue;
        out +=
            fmt::format("{}: {} -> {}\n", entry.upload.student, before.at("points").get<std::string>(), entry.graded);
        Report const old = read_if_there(results / before.at("key").get<std::string>() / "report.json");
        if (old.contains("status"))
            out += indented(diff_reports(old, entry.report, language).text);
    }
    return out;
}

void Applied::remember(std::vector<GradedUpload> const& entries) const
{
    Report document = Report::object();
    for (auto const& entry : entries)
        document[entry.upload.student] = {
            {"key", entry.key}, {"sha256", entry.report.at("submission").at("sha256")}, {"points", entry.graded}};
    write_atomically(file_, to_text(document));
}
}  // namespace testat
