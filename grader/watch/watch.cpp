#include "watch/watch.h"

#include "process/run.h"
#include "report/report.h"
#include "text.h"
#include "watch/changes.h"
#include "watch/saves.h"

#include <optional>
#include <ostream>
#include <stdexcept>

namespace testat {
namespace {
class Watcher {
public:
    Watcher(WatchOptions const& options, Installation const& where, std::ostream& text)
        : options_(options), where_(where), text_(text)
    {
    }

    void look()
    {
        Finished const finished = run(grade_command());
        // The file may have gone in the meantime; the next save is another one.
        if (!std::filesystem::is_regular_file(options_.file))
            return;
        if (finished.exit_code != 0)
            return print(clean_text(finished.output, 4000));
        show(read_report(options_.out / "report.json", where_.rubric.parent_path() / "report.schema.json"));
    }

private:
    Command grade_command() const
    {
        constexpr double longest_s = 300;  // what is the upload's doing ends much earlier
        Command command;
        command.argv = {options_.program, "grade",
                        "--lang",         options_.language == Language::de ? "de" : "en",
                        "--out",          std::filesystem::absolute(options_.out)};
        command.argv.insert(command.argv.end(), options_.grade_options.begin(), options_.grade_options.end());
        command.argv.insert(command.argv.end(), {"--", std::filesystem::absolute(options_.file)});
        command.variables = {"TMPDIR=" + workplace_.path().string()};  // whatever a Ctrl-C leaves there goes with it
        command.wall_s = longest_s;
        return command;
    }

    void show(Report report)
    {
        print(changes_to_text(before_ ? &*before_ : nullptr, report, options_.language));
        before_ = std::move(report);
    }

    void print(std::string const& words)
    {
        text_ << words << "\n";
        if (!text_.flush())
            throw std::runtime_error("the output could not be written");
    }

    WatchOptions const& options_;
    Installation const& where_;
    std::ostream& text_;
    TemporaryDirectory workplace_;
    std::optional<Report> before_;  ///< the last that was graded
};
}  // namespace

void watch(WatchOptions const& options, Installation const& where, std::ostream& text)
{
    if (!std::filesystem::is_regular_file(options.file))
        throw std::invalid_argument(options.file.string() + ": there is no such file to watch");
    Saves saves(options.file);
    Watcher watcher(options, where, text);
    for (;; saves.wait())
        watcher.look();
}
}  // namespace testat
