#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What was handed to us, a zip or a folder, as a list of names, which never serve as paths, and files.
namespace testat {
struct Entry {
    std::string name;            ///< parts joined by '/', one line of valid UTF-8; not unique; never empty, "." or ".."
    std::filesystem::path file;  ///< where its bytes are; empty for a folder
    std::optional<std::int64_t> modified = {};  ///< seconds since 1970, if known
};

struct Contents {
    std::vector<Entry> entries;
    std::vector<std::string> remarks;  ///< entries left out, and why
};

/// More than any course hands in.
constexpr std::size_t max_entries = 10'000;

/// Everything below a folder; links and special files are left out with a remark, hidden files without one. Throws
/// std::invalid_argument if that is more than `max_entries` or cannot be read.
Contents list_folder(std::filesystem::path const& folder);

/// The name of an entry from bytes of any kind: Windows' backslashes become slashes, invalid UTF-8 is replaced. Empty,
/// with the reason in `why`, if it is absolute or leaves its folder.
std::string entry_name(std::string_view bytes, std::string& why);

/// "a/b/c" as {"a", "b", "c"}.
std::vector<std::string> parts_of(std::string_view name);

/// What macOS, Windows and version control leave behind.
bool is_junk(std::string_view name);
}  // namespace testat
