#include "batch/ilias.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
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
}  // namespace

void write_feedback_zip(std::vector<GradedUpload> const& entries, std::string const& title,
                        std::string const& assignment, Language language, std::filesystem::path const& file)
{
    std::string top = "multi_feedback_" + title + "_" + assignment;
    std::replace(top.begin(), top.end(), ' ', '_');
    std::replace(top.begin(), top.end(), '/', '_');
    Zip zip(file);
    for (auto const& entry : entries)
        for (auto const& folder : folders_of(entry.upload))
            if (entry.is_graded())
                zip.add(top + "/" + folder + "/testat.txt", report_to_text(entry.report, language));
    zip.close();
}
}  // namespace testat
