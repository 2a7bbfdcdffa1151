#include "batch/contents.h"

#include "text.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace testat {
namespace {
/// Longer names are nobody's.
constexpr std::size_t max_name = 2000;  // bytes

std::optional<std::int64_t> modified(std::filesystem::path const& file)
{
    struct stat status {};
    if (stat(file.c_str(), &status) != 0)
        return std::nullopt;
    return status.st_mtime;
}

bool is_drive(std::string_view name)
{
    return name.size() >= 2 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
}

void add(Contents& contents, std::filesystem::directory_entry const& found, std::string const& name)
{
    if (found.is_symlink() || !(found.is_regular_file() || found.is_directory()))
        contents.remarks.push_back(fmt::format("'{}' is a link or a special file and was left out.", name));
    else if (found.is_directory())
        contents.entries.push_back({name, {}});
    else
        contents.entries.push_back({name, found.path(), modified(found.path())});
}
}  // namespace

std::vector<std::string> parts_of(std::string_view name)
{
    std::vector<std::string> parts;
    while (!name.empty()) {
        std::string_view const part = name.substr(0, name.find('/'));
        if (!part.empty() && part != ".")
            parts.emplace_back(part);
        name.remove_prefix(std::min(name.size(), part.size() + 1));
    }
    return parts;
}

std::string entry_name(std::string_view bytes, std::string& why)
{
    std::string name = one_line(bytes, max_name);
    std::replace(name.begin(), name.end(), '\\', '/');
    auto const parts = parts_of(name);
    if (name.rfind('/', 0) == 0 || is_drive(name))
        why = "its path is absolute";
    else if (std::find(parts.begin(), parts.end(), "..") != parts.end())
        why = "its path leaves the folder with '..'";
    else if (parts.empty())
        why = "it has no name";
    if (!why.empty())
        return "";
    std::string joined;
    for (auto const& part : parts)
        joined += (joined.empty() ? "" : "/") + part;
    return joined;
}

bool is_junk(std::string_view name)
{
    auto const parts = parts_of(name);
    return std::any_of(parts.begin(), parts.end(), [](std::string const& part) {
        return part[0] == '.' || part == "__MACOSX" || part == "Thumbs.db" || part == "desktop.ini";
    });
}

Contents list_folder(std::filesystem::path const& folder)
try {
    Contents contents;
    std::size_t count = 0;
    std::filesystem::recursive_directory_iterator at(folder);
    for (; at != std::filesystem::recursive_directory_iterator(); ++at) {
        std::string const relative = at->path().lexically_relative(folder).string();
        if (is_junk(relative)) {
            at.disable_recursion_pending();
            continue;
        }
        if (++count > max_entries)
            throw std::invalid_argument(
                fmt::format("'{}' holds more than {} files and folders. Is it the folder with the uploads?",
                            one_line(folder.string()), max_entries));
        add(contents, *at, one_line(relative, max_name));
    }
    std::sort(contents.entries.begin(), contents.entries.end(),
              [](Entry const& a, Entry const& b) { return a.name < b.name; });
    return contents;
} catch (std::filesystem::filesystem_error const& error) {
    throw std::invalid_argument(fmt::format("'{}' cannot be read: {}. Check its permissions.",
                                            one_line(folder.string()), error.code().message()));
}
}  // namespace testat
