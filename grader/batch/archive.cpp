#include "batch/archive.h"

#include "batch/names.h"
#include "text.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <array>
#include <clocale>
#include <memory>
#include <stdexcept>

namespace testat {
namespace {
namespace fs = std::filesystem;

constexpr std::uint64_t ratio_counts_from = 1 << 20;  // bytes
constexpr std::int64_t end_of_1980 = 347'155'200;     // a zip without times says 1980

/// libarchive gives names in the locale's encoding: UTF-8 for this thread, as long as this lives.
class Utf8Locale {
public:
    Utf8Locale() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", locale_t{}))
    {
        if (utf8_ != locale_t{})
            before_ = uselocale(utf8_);
    }
    ~Utf8Locale()
    {
        if (utf8_ == locale_t{})
            return;
        uselocale(before_);
        freelocale(utf8_);
    }
    Utf8Locale(Utf8Locale const&) = delete;
    Utf8Locale& operator=(Utf8Locale const&) = delete;

private:
    locale_t utf8_;
    locale_t before_{};
};

struct Free {
    void operator()(archive* a) const { archive_free(a); }
    void operator()(archive_entry* e) const { archive_entry_free(e); }
};
using Archive = std::unique_ptr<archive, Free>;

std::string message_of(archive* a)
{
    char const* const text = archive_error_string(a);
    return text == nullptr ? "no reason given" : one_line(text, 300);
}

class Unpacking {
public:
    Unpacking(fs::path const& zip, fs::path const& directory)
        : zip_(one_line(zip.filename().string())),
          directory_(fs::canonical(directory)),
          in_(archive_read_new()),
          out_(archive_write_disk_new())
    {
        // The reader that starts from the directory at the end, as everybody's unzip does: the other one, for streams,
        // can see other entries in the same file.
        archive_read_support_format_zip_seekable(in_.get());
        archive_write_disk_set_options(out_.get(), ARCHIVE_EXTRACT_SECURE_SYMLINKS | ARCHIVE_EXTRACT_SECURE_NODOTDOT |
                                                       ARCHIVE_EXTRACT_NO_OVERWRITE | ARCHIVE_EXTRACT_TIME);
        if (archive_read_open_filename(in_.get(), zip.c_str(), 1 << 16) != ARCHIVE_OK)
            throw std::invalid_argument(
                fmt::format("'{}' is not a zip, or only the beginning of one ({}). Download it again.", zip_,
                            message_of(in_.get())));
    }

    Contents all()
    {
        while (archive_entry* const entry = next())
            take(entry);
        return std::move(contents_);
    }

private:
    /// Null at the end.
    archive_entry* next()
    {
        archive_entry* entry = nullptr;
        int const result = archive_read_next_header(in_.get(), &entry);
        if (result == ARCHIVE_EOF)
            return nullptr;
        if (result < ARCHIVE_WARN)
            damaged(fmt::format("after entry {}", count_));
        if (++count_ > max_entries)
            throw std::invalid_argument(fmt::format(
                "'{}' has more than {} entries, more than any course hands in. Look into it, and unpack what "
                "is wanted into a folder.",
                zip_, max_entries));
        return entry;
    }

    void take(archive_entry* entry)
    {
        char const* const bytes = archive_entry_pathname(entry);
        std::string why;
        std::string const name = entry_name(bytes == nullptr ? "" : bytes, why);
        if (!why.empty())
            return refuse(bytes == nullptr ? "" : one_line(bytes, 300), why);
        if (is_junk(name))
            return;
        if (archive_entry_filetype(entry) == AE_IFDIR)
            contents_.entries.push_back({name, {}});
        else if (why = objection(entry); !why.empty())
            refuse(name, why);
        else
            write(name, entry);
    }

    static std::string objection(archive_entry* entry)
    {
        if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr)
            return "it is a link or a device";
        if (archive_entry_is_encrypted(entry) != 0)
            return "it is encrypted";
        if (archive_entry_size(entry) < 0 || std::uint64_t(archive_entry_size(entry)) > max_entry_bytes)
            return too_large();
        return "";
    }

    static std::string too_large() { return fmt::format("it is larger than {} MB", max_entry_bytes >> 20); }

    void refuse(std::string const& name, std::string const& why)
    {
        contents_.remarks.push_back(fmt::format("'{}' in '{}' was left out: {}.", name, zip_, why));
    }

    void write(std::string const& name, archive_entry* source)
    {
        fs::path const folder = directory_ / fmt::format("{:05}", count_);
        fs::path const file = folder / safe_file_name(parts_of(name).back());
        std::optional<std::int64_t> modified;
        if (archive_entry_mtime_is_set(source) != 0 && archive_entry_mtime(source) > end_of_1980)
            modified = archive_entry_mtime(source);
        fs::create_directory(folder);
        open(file, modified);
        std::string const why = copy(name);
        if (archive_write_finish_entry(out_.get()) < ARCHIVE_WARN)
            cannot_write(file);
        if (why.empty())
            return contents_.entries.push_back({name, file, modified});
        fs::remove_all(folder);
        refuse(name, why);
    }

    /// A plain file with rights of our choosing.
    void open(fs::path const& file, std::optional<std::int64_t> modified)
    {
        std::unique_ptr<archive_entry, Free> const entry(archive_entry_new());
        archive_entry_copy_pathname(entry.get(), file.c_str());
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0600);
        if (modified)
            archive_entry_set_mtime(entry.get(), *modified, 0);
        if (archive_write_header(out_.get(), entry.get()) < ARCHIVE_WARN)
            cannot_write(file);
    }

    /// Why the entry is not wanted after all, or nothing. What the zip says about sizes is not believed.
    std::string copy(std::string const& name)
    {
        std::array<char, 1 << 16> buffer;
        std::int64_t const start = archive_filter_bytes(in_.get(), -1);
        std::uint64_t size = 0;
        for (;;) {
            la_ssize_t const read = archive_read_data(in_.get(), buffer.data(), buffer.size());
            if (read < 0)
                damaged("in '" + name + "'");
            if (read == 0)
                break;
            size += std::uint64_t(read);
            count_bytes(std::uint64_t(read), name);
            if (size > max_entry_bytes)
                return too_large();
            if (archive_write_data(out_.get(), buffer.data(), std::size_t(read)) < 0)
                cannot_write(name);
        }
        std::uint64_t const packed =
            std::uint64_t(std::max<std::int64_t>(1, archive_filter_bytes(in_.get(), -1) - start));
        if (size > ratio_counts_from && size / packed >= max_ratio)
            return fmt::format("it is packed to less than 1/{} of its size, as no source file is", max_ratio);
        return "";
    }

    void count_bytes(std::uint64_t read, std::string const& name)
    {
        total_ += read;
        if (total_ > max_unpacked_bytes)
            throw std::invalid_argument(fmt::format(
                "'{}' unpacks to more than {} MB (stopped at '{}'). Look into it, and unpack what is wanted "
                "into a folder.",
                zip_, max_unpacked_bytes >> 20, name));
    }

    [[noreturn]] void damaged(std::string const& where)
    {
        throw std::invalid_argument(
            fmt::format("'{}' is damaged {}: {}. Download it again.", zip_, where, message_of(in_.get())));
    }

    [[noreturn]] void cannot_write(fs::path const& file)
    {
        throw std::runtime_error(fmt::format("cannot write '{}': {}", one_line(file.string()), message_of(out_.get())));
    }

    std::string zip_;
    fs::path directory_;
    Archive in_;
    Archive out_;
    Contents contents_;
    std::size_t count_ = 0;
    std::uint64_t total_ = 0;  ///< bytes unpacked, refused ones as well
};

void empty(fs::path const& directory)
{
    std::error_code ignored;
    for (auto const& entry : fs::directory_iterator(directory, ignored))
        fs::remove_all(entry.path(), ignored);
}
}  // namespace

Contents unpack(fs::path const& zip, fs::path const& directory)
{
    fs::create_directories(directory);
    if (!fs::is_empty(directory))
        throw std::runtime_error(fmt::format("'{}' is not empty", one_line(directory.string())));
    Utf8Locale const utf8;
    try {
        return Unpacking(zip, directory).all();
    } catch (...) {
        empty(directory);
        throw;
    }
}
}  // namespace testat
