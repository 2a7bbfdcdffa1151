#include "batch/ilias.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace testat {
namespace {
/// The first moment that a zip can name.
constexpr std::time_t fixed_time = 315'532'800;

class Zip {
public:
    explicit Zip(std::filesystem::path const& file) : archive_(archive_write_new(), archive_write_free)
    {
        check(archive_write_set_format_zip(archive_.get()));
        check(archive_write_set_options(archive_.get(), "hdrcharset=UTF-8"));
        check(archive_write_open_filename(archive_.get(), file.c_str()));
    }

    void add(std::string const& name, std::string const& bytes)
    {
        std::unique_ptr<archive_entry, void (*)(archive_entry*)> const entry(archive_entry_new(), archive_entry_free);
        archive_entry_set_pathname_utf8(entry.get(), name.c_str());
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0644);
        archive_entry_set_mtime(entry.get(), fixed_time, 0);
        check(archive_write_header(archive_.get(), entry.get()));
        if (archive_write_data(archive_.get(), bytes.data(), bytes.size()) != la_ssize_t(bytes.size()))
            check(ARCHIVE_FATAL);
    }

    void close() { check(archive_write_close(archive_.get())); }

private:
    void check(int result) const
    {
        if (result == ARCHIVE_OK)
            return;
        char const* const why = archive_error_string(archive_.get());
        throw std::runtime_error(std::string("the feedback's zip: ") + (why == nullptr ? "cannot be written" : why));
    }

    std::unique_ptr<archive, int (*)(archive*)> archive_;
};

std::vector<std::string> folders_of(Upload const& upload)
{
    return upload.members.empty() ? std::vector<std::string>{upload.folder} : upload.members;
}

std::string page_of(GradedUpload const& entry, std::filesystem::path const& reports)
{
    auto const file = reports / entry.upload.student / "report.html";
    std::ifstream in(file, std::ios::binary);
    std::string page{std::istreambuf_iterator<char>(in), {}};
    if (page.empty())
        throw std::runtime_error("the feedback's zip: cannot read " + file.string());
    return page;
}
}  // namespace

void write_feedback_zip(std::vector<GradedUpload> const& entries, std::filesystem::path const& reports,
                        std::string const& title, std::string const& assignment, std::filesystem::path const& file)
{
    std::string top = "multi_feedback_" + title + "_" + assignment;
    std::replace(top.begin(), top.end(), ' ', '_');
    std::replace(top.begin(), top.end(), '/', '_');
    Zip zip(file);
    for (auto const& entry : entries) {
        if (!entry.is_graded())
            continue;
        std::string const page = page_of(entry, reports);
        for (auto const& folder : folders_of(entry.upload))
            zip.add(top + "/" + folder + "/testat.html", page);
    }
    zip.close();
}
}  // namespace testat
