#include "batch/intake.h"

#include "batch/archive.h"
#include "batch/names.h"
#include "batch/table.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace testat {
namespace {
namespace fs = std::filesystem;

/// Files of one student less far apart than this were copied rather than handed in: then their numbers count.
constexpr std::int64_t same_time_s = 60;

struct Candidate {
    Entry entry;
    FileName name;
    std::string folder;  ///< of the user, as exported
};

/// A student's files, or a team's.
struct Group {
    std::string team;
    std::set<std::string> folders;
    std::vector<Candidate> files;
};

/// By student or team.
using Groups = std::map<std::string, Group>;

std::string base_name(std::string const& name)
{
    return name.substr(name.rfind('/') + 1);
}

std::string parent(std::string const& name)
{
    std::size_t const slash = name.rfind('/');
    return slash == std::string::npos ? "" : name.substr(0, slash);
}

std::string stem(std::string const& name)
{
    std::size_t const dot = name.rfind('.');
    return dot == 0 ? name : name.substr(0, dot);
}

bool ends_with(std::string const& text, std::string_view end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_archive(std::string const& name)
{
    constexpr char const* endings[] = {".zip", ".tar", ".gz", ".tgz", ".xz", ".7z", ".rar", ".bz2"};
    return std::any_of(std::begin(endings), std::end(endings),
                       [&](char const* ending) { return ends_with(lower_case(name), ending); });
}

/// "<Title>/<Title>.xlsx"
bool is_table(Entry const& entry)
{
    return !entry.file.empty() && ends_with(lower_case(entry.name), ".xlsx") && base_name(entry.name)[0] != '~';
}

std::set<std::string> folders_in(std::vector<Entry> const& entries)
{
    std::set<std::string> folders;
    for (auto const& entry : entries)
        for (std::string at = entry.file.empty() ? entry.name : parent(entry.name); !at.empty(); at = parent(at))
            folders.insert(at);
    return folders;
}

bool is_below(std::string const& name, std::string const& folder)
{
    return folder.empty() || (name.size() > folder.size() && name[folder.size()] == '/' && name.rfind(folder, 0) == 0);
}

/// The folder around all others that are named like users: a title can be named like one, too. Empty if there is none.
/// What students hand in has a say in it only where there is but one of them.
std::string enclosing(std::vector<Entry> const& entries, std::set<std::string> const& named)
{
    auto const encloses = [&](std::string const& folder) {
        return std::all_of(named.begin(), named.end(), [&](std::string const& other) {
            return other == folder || is_below(other, folder) || is_below(folder, other);
        });
    };
    std::string title;
    for (auto const& entry : entries) {
        std::string const folder = parent(entry.name);
        bool const is_title = is_table(entry) && stem(base_name(entry.name)) == base_name(folder) && encloses(folder);
        if (is_title && (title.empty() || folder.size() < title.size()))
            title = folder;
    }
    if (!title.empty())
        return title;
    std::set<std::string> with_source;
    for (auto const& entry : entries)
        if (parse_file_name(entry.name).is_source)
            with_source.insert(parent(entry.name));
    for (auto const& folder : named)
        if (folder != *named.rbegin() && with_source.count(folder) == 0 && encloses(folder))
            title = folder;
    return title;
}

/// The outermost folders named like users: students can have some in theirs.
std::set<std::string> user_folders(std::vector<Entry> const& entries)
{
    std::set<std::string> named;
    for (auto const& folder : folders_in(entries))
        if (parse_user_folder(base_name(folder)))
            named.insert(folder);
    std::string const title = enclosing(entries, named);
    std::set<std::string> users;
    for (auto const& folder : named) {
        std::string above = parent(folder);
        while (!above.empty() && above != title && named.count(above) == 0)
            above = parent(above);
        if (above == title && is_below(folder, title))
            users.insert(folder);
    }
    return users;
}

/// The user folder that an entry lies in, or is; empty if there is none.
std::string user_of(std::string const& name, std::set<std::string> const& users)
{
    std::string at = name;
    while (!at.empty() && users.count(at) == 0)
        at = parent(at);
    return at;
}

/// Absolute, without a slash at the end.
fs::path whole(fs::path const& path)
{
    fs::path const normal = fs::absolute(path).lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();
}

class Reader {
public:
    Reader(fs::path const& input, fs::path const& scratch, std::optional<std::int64_t> deadline)
        : input_(input), scratch_(scratch), deadline_(deadline)
    {
        if (!fs::exists(input))
            throw std::invalid_argument(fmt::format("There is no '{}'.", one_line(input.string())));
        is_folder_ = fs::is_directory(input);
        if (!is_folder_ && !fs::is_regular_file(input))
            throw std::invalid_argument(fmt::format("'{}' is neither a file nor a folder.", one_line(input.string())));
        Contents contents = is_folder_ ? list_folder(input) : unpack(input, scratch / "files");
        entries_ = std::move(contents.entries);
        intake_.remarks = std::move(contents.remarks);
    }

    Intake read()
    {
        users_ = user_folders(entries_);
        intake_.is_ilias = !users_.empty();
        intake_.title = intake_.is_ilias ? ilias_title() : own_name();
        Groups const groups = intake_.is_ilias ? ilias_groups() : flat_groups();
        for (auto const& [student, group] : groups)
            add(student, group);
        if (intake_.is_ilias)
            read_table();
        else if (intake_.uploads.empty())
            nothing_found();
        for (Upload& upload : intake_.uploads)
            upload.late = upload.late || (deadline_ && upload.submitted && *upload.submitted > *deadline_);
        name_reports();
        return std::move(intake_);
    }

private:
    std::string own_name() const
    {
        std::string const name = whole(input_).filename().string();
        return one_line(is_folder_ ? name : stem(name));
    }

    /// What is before the user folder: {"Title", "Submissions"}, or less if the input is one of them.
    std::string ilias_title() const
    {
        auto above = parts_of(parent(*users_.begin()));
        if (!above.empty() && parse_team(above.back()))
            above.pop_back();
        if (above.size() >= 2)
            return above[above.size() - 2];
        for (auto const& entry : entries_)
            if (is_table(entry) && user_of(entry.name, users_).empty())
                return stem(base_name(entry.name));
        bool const is_submissions = above.empty() && is_folder_;
        return is_submissions ? one_line(whole(input_).parent_path().filename().string()) : own_name();
    }

    void remark(std::string text) { intake_.remarks.push_back(std::move(text)); }

    Groups ilias_groups()
    {
        Groups groups;
        for (auto const& user : users_)
            group_of(groups, user).folders.insert(base_name(user));
        for (auto const& entry : entries_) {
            std::string const user = user_of(entry.name, users_);
            if (entry.file.empty() || (user.empty() && is_table(entry)))
                continue;
            if (user.empty())
                remark(fmt::format("'{}' lies in no student's folder and was left out.", entry.name));
            else
                add_file(group_of(groups, user), entry, base_name(user));
        }
        return groups;
    }

    static Group& group_of(Groups& groups, std::string const& user)
    {
        std::string const team = parse_team(base_name(parent(user))).value_or("");
        Group& group = groups[team.empty() ? base_name(user) : "team " + team];
        group.team = team;
        return group;
    }

    struct Level {
        std::set<std::string> folders;
        std::vector<std::string> files;
    };

    /// What is directly below a folder; `prefix` is empty or ends with a slash.
    Level level(std::string const& prefix) const
    {
        Level level;
        for (auto const& entry : entries_) {
            if (entry.name.size() <= prefix.size() || entry.name.rfind(prefix, 0) != 0)
                continue;
            auto const parts = parts_of(entry.name.substr(prefix.size()));
            if (parts.size() == 1 && !entry.file.empty())
                level.files.push_back(parts[0]);
            else
                level.folders.insert(parts[0]);
        }
        return level;
    }

    /// Folders around everything, as a prefix. The folder of a single student is none.
    std::string wrapper() const
    {
        std::string prefix;
        for (;;) {
            Level const here = level(prefix);
            if (here.folders.size() != 1 || !here.files.empty())
                return prefix;
            std::string const inner = prefix + *here.folders.begin() + "/";
            auto const files = level(inner).files;
            if (std::any_of(files.begin(), files.end(), [](auto const& f) { return parse_file_name(f).is_expected; }))
                return prefix;
            prefix = inner;
        }
    }

    Groups flat_groups()
    {
        Groups groups;
        std::string const prefix = wrapper();
        for (auto const& entry : entries_)
            if (entry.name.size() > prefix.size())
                add_flat(groups, entry, parts_of(entry.name.substr(prefix.size())));
        return groups;
    }

    void add_flat(Groups& groups, Entry const& entry, std::vector<std::string> const& parts)
    {
        bool const is_file = !entry.file.empty();
        if (parts.size() > 1 || !is_file)
            groups["folder " + parts[0]].folders.insert(parts[0]);
        if (is_file && parts.size() > 1)
            add_file(groups["folder " + parts[0]], entry, parts[0]);
        else if (is_file && parse_file_name(parts[0]).is_source)
            add_file(groups["file " + parts[0]], entry, stem(parts[0]));
        else if (is_file)
            leave_out(entry);
    }

    void add_file(Group& group, Entry const& entry, std::string const& folder)
    {
        FileName const name = parse_file_name(base_name(entry.name));
        group.folders.insert(folder);
        if (name.is_source)
            group.files.push_back({entry, name, folder});
        else
            leave_out(entry);
    }

    void leave_out(Entry const& entry)
    {
        if (is_archive(entry.name))
            remark(fmt::format("'{}' is an archive; it was left packed.", entry.name));
        else
            remark(fmt::format("'{}' is not a .cpp file and was left out.", entry.name));
    }

    /// Newest first.
    static void sort(std::vector<Candidate>& files)
    {
        auto const time = [](Candidate const& c) { return c.entry.modified.value_or(0); };
        auto const by_time = [&](Candidate const& a, Candidate const& b) { return time(a) < time(b); };
        auto const [oldest, newest] = std::minmax_element(files.begin(), files.end(), by_time);
        bool const times_differ = time(*newest) - time(*oldest) > same_time_s;
        std::stable_sort(files.begin(), files.end(), [&](Candidate const& a, Candidate const& b) {
            auto const rank = [&](Candidate const& c) {
                std::int64_t const number = c.name.number;
                return std::tuple(c.name.is_expected, times_differ ? time(c) : number, times_differ ? number : time(c));
            };
            return rank(b) < rank(a);
        });
    }

    void add(std::string const& name, Group group)
    {
        if (group.files.empty()) {
            std::string const who = group.team.empty() ? *group.folders.begin() : name;
            return remark(fmt::format("'{}' has handed in no .cpp file.", who));
        }
        sort(group.files);
        Candidate const& newest = group.files.front();
        Upload upload;
        upload.student = newest.folder;
        upload.folder = intake_.is_ilias ? newest.folder : "";
        upload.team = group.team;
        if (!group.team.empty())
            upload.members.assign(group.folders.begin(), group.folders.end());
        upload.file = newest.entry.file;
        upload.submitted = newest.entry.modified;
        upload.late = newest.name.is_late && (intake_.is_ilias || newest.name.is_expected);
        for (std::size_t i = 1; i < group.files.size(); ++i)
            upload.older.push_back(group.files[i].entry.file);
        if (intake_.is_ilias)
            read_folder_name(upload);
        intake_.uploads.push_back(upload);
    }

    static void read_folder_name(Upload& upload)
    {
        auto const folder = parse_user_folder(upload.student);
        upload.usr_id = folder->usr_id;
        std::string const& person = folder->person;
        std::size_t const first = person.find('_');
        std::size_t const second = person.rfind('_');
        if (std::count(person.begin(), person.end(), '_') != 2)
            return;  // which one is between two names cannot be known
        upload.lastname = person.substr(0, first);
        upload.firstname = person.substr(first + 1, second - first - 1);
        upload.login = person.substr(second + 1);
    }

    void read_table()
    {
        for (auto const& entry : entries_)
            if (is_table(entry) && user_of(entry.name, users_).empty())
                return read_table(entry);
        remark("The download has no .xlsx, so times of submission are those of the files.");
    }

    void read_table(Entry const& entry)
    try {
        use(read_xlsx(entry.file, scratch_ / "table"), entry.name);
    } catch (std::invalid_argument const& error) {
        remark(fmt::format("'{}' cannot be read ({}), so times of submission are those of the files.", entry.name,
                           error.what()));
    }

    void use(Rows const& rows, std::string const& name)
    {
        std::vector<std::string> folders;
        for (auto const& user : users_)
            folders.push_back(base_name(user));
        std::vector<std::string> persons;
        for (auto const& folder : folders)
            persons.push_back(parse_user_folder(folder)->person);
        Joined const joined = join(rows, persons);
        for (std::size_t i = 0; i < folders.size(); ++i)
            for (Upload& upload : intake_.uploads) {
                bool const is_member =
                    std::find(upload.members.begin(), upload.members.end(), folders[i]) != upload.members.end();
                if (is_member && joined.submitters[i])
                    upload.logins.push_back(joined.submitters[i]->login);
                if (upload.folder == folders[i])
                    complete(upload, joined.submitters[i], name);
            }
        for (auto const& submitter : joined.without_folder)
            remark(fmt::format("{} {} ({}) is in '{}', but has no folder.", submitter.firstname, submitter.lastname,
                               submitter.login, name));
    }

    void complete(Upload& upload, std::optional<Submitter> const& submitter, std::string const& table)
    {
        if (!submitter)
            return remark(fmt::format("'{}' is not in '{}', so the time of submission is that of the file.",
                                      upload.student, table));
        upload.lastname = submitter->lastname;
        upload.firstname = submitter->firstname;
        upload.login = submitter->login;
        if (submitter->submitted)
            upload.submitted = submitter->submitted;
    }

    [[noreturn]] void nothing_found() const
    {
        std::string const because = intake_.remarks.empty() ? "" : " " + intake_.remarks.front();
        throw std::invalid_argument(
            fmt::format("'{}' has no uploads in it: neither ILIAS's folders <Lastname>_<Firstname>_<login>_<number>, "
                        "nor .cpp files, nor folders with .cpp files.{} Give the zip as ILIAS made it, or a folder of "
                        ".cpp files.",
                        one_line(input_.string()), because));
    }

    void name_reports()
    {
        std::stable_sort(intake_.uploads.begin(), intake_.uploads.end(),
                         [](Upload const& a, Upload const& b) { return a.student < b.student; });
        UniqueNames names;
        for (Upload& upload : intake_.uploads)
            upload.student = names.add(safe_file_name(upload.student));
    }

    fs::path input_;
    fs::path scratch_;
    std::optional<std::int64_t> deadline_;
    bool is_folder_ = false;
    std::vector<Entry> entries_;
    std::set<std::string> users_;  ///< whole names
    Intake intake_;
};
}  // namespace

Intake take_in(fs::path const& input, fs::path const& scratch, std::optional<std::int64_t> deadline)
{
    return Reader(input, scratch, deadline).read();
}
}  // namespace testat
