#include "batch/batch.h"
#include "report/reading.h"
#include "report/wrap.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace testat {
namespace {
constexpr Term uploads{"{} Abgaben, {} bewertet, {} mit mindestens 60 %",
                       "{} uploads, {} graded, {} with 60 % or more"};
constexpr Term mean_points{"Mittel {:.2f} von {:.2f} Punkten", "mean {:.2f} of {:.2f} points"};
constexpr Term totals{"Punkte insgesamt", "Points"};
constexpr Term by_task{"Nach Aufgabe (Mittel)", "By task (mean)"};
constexpr Term task_term{"Aufgabe", "task"};
constexpr Term mistakes{"Gleiche Fehler", "The same mistake"};
constexpr Term not_built{"Lassen sich nicht übersetzen", "Do not compile"};
constexpr Term crashed{"Stürzen beim Erzeugen der Bilder ab", "Crash while making the pictures"};
constexpr Term late{"Verspätet", "Late"};
constexpr Term not_gradable{"Nicht bewertbar (kein Fehler der Abgabe)", "Not gradable (not the upload's fault)"};
constexpr Term slowest{"Am langsamsten (s)", "Slowest (s)"};
constexpr Term overridden{"Von Hand geändert", "Changed by hand"};
constexpr Term older_files{"Ältere Dateien, die nicht zählen", "Older files, which do not count"};
constexpr Term largest{"Am größten (KB)", "Largest (KB)"};
constexpr Term remarks_term{"Beim Einlesen", "While reading"};

using Names = std::vector<std::string>;

class SummaryPrinter : Printer {
public:
    SummaryPrinter(std::vector<GradedUpload> const& entries, Language language) : Printer(language), entries_(entries)
    {
        for (auto const& entry : entries)
            if (entry.is_graded())
                graded_.push_back(&entry);
    }

    std::string print(Names const& remarks)
    {
        headline();
        if (!graded_.empty()) {
            histogram();
            tasks();
            same_mistakes();
            slow();
            large();
        }
        list(not_built,
             named([](GradedUpload const& e) { return !e.report.at("build").at("ok").template get<bool>(); }));
        list(crashed, named([](GradedUpload const& e) {
                 auto const& applied = e.report.at("policy").at("applied");
                 return std::find(applied.begin(), applied.end(), "crashes") != applied.end();
             }));
        list(overridden, changes_by_hand());
        list(older_files, older());
        Names late_ones, failed;
        for (auto const& entry : entries_) {
            if (entry.upload.late)
                late_ones.push_back(entry.upload.student);
            if (!entry.is_graded())
                failed.push_back(entry.upload.student + ": " + text(entry.report.at("error")));
        }
        list(late, late_ones);
        list(not_gradable, failed);
        list(remarks_term, remarks);
        return std::move(out_);
    }

private:
    static constexpr std::size_t shown = 5;

    static double earned(GradedUpload const& entry) { return entry.report.at("points").at("earned"); }
    static double max(GradedUpload const& entry) { return entry.report.at("points").at("max"); }

    template <typename Wanted>
    Names named(Wanted const& wanted) const
    {
        Names names;
        for (GradedUpload const* entry : graded_)
            if (wanted(*entry))
                names.push_back(entry->upload.student);
        return names;
    }

    Names changes_by_hand() const
    {
        Names changes;
        for (GradedUpload const* entry : graded_)
            for (auto const& change : Reading(entry->report).by_hand())
                changes.push_back(entry->upload.student + ": " + one_line(change));
        return changes;
    }

    Names older() const
    {
        Names files;
        for (auto const& entry : entries_)
            for (auto const& file : entry.upload.older)
                files.push_back(entry.upload.student + ": " + one_line(file.filename().string()));
        return files;
    }

    void list(Term title, Names const& names)
    {
        if (names.empty())
            return;
        line("\n{} ({})", say(title), names.size());
        for (auto const& name : names)
            line("  {}", name);
    }

    void headline()
    {
        auto const passed = named(
            [](GradedUpload const& e) { return e.report.at("points").at("passed_60_percent").template get<bool>(); });
        line("{}", fmt::format(fmt::runtime(say(uploads)), entries_.size(), graded_.size(), passed.size()));
        if (graded_.empty())
            return;
        double sum = 0;
        for (GradedUpload const* entry : graded_)
            sum += earned(*entry);
        line("{}", fmt::format(fmt::runtime(say(mean_points)), sum / double(graded_.size()), max(*graded_.front())));
    }

    void histogram()
    {
        constexpr double step = 2;
        std::map<int, std::size_t> counts;
        for (GradedUpload const* entry : graded_)
            ++counts[int(std::min(earned(*entry), max(*entry) - step / 2) / step)];
        line("\n{}", say(totals));
        for (int bin = 0; step * bin < max(*graded_.front()); ++bin)
            line("  {:5.1f} - {:5.1f}  {:4} {}", step * bin, step * (bin + 1), counts[bin],
                 std::string(50 * counts[bin] / graded_.size(), '#'));
    }

    void tasks()
    {
        line("\n{}", say(by_task));
        auto const& tasks = graded_.front()->report.at("tasks");
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            double sum = 0;
            for (GradedUpload const* entry : graded_)
                sum += entry->report.at("tasks").at(i).at("earned").get<double>();
            line("  {} {}: {:.2f} / {:.2f}", say(task_term), text(tasks.at(i).at("id")), sum / double(graded_.size()),
                 tasks.at(i).at("max").get<double>());
        }
    }

    /// One comment serves many.
    void same_mistakes()
    {
        std::map<std::string, Names> groups;
        for (GradedUpload const* entry : graded_)
            for (auto const& [name, function] : entry->report.at("functions").items())
                if (function.contains("mistake"))
                    groups[text(function.at("mistake").at("id")) + ": " + phrase(function.at("mistake"))].push_back(
                        entry->upload.student);
        std::vector<std::pair<std::string, Names>> sorted(groups.begin(), groups.end());
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](auto const& a, auto const& b) { return a.second.size() > b.second.size(); });
        for (auto const& [mistake, names] : sorted) {
            line("\n{}: {}", say(mistakes), wrap_words(mistake, 4, columns_of(say(mistakes)) + 2));
            for (auto const& name : names)
                line("  {}", name);
        }
    }

    void large()
    {
        std::vector<std::pair<std::uintmax_t, std::string>> sizes;
        for (auto const& entry : entries_) {
            std::error_code error;
            auto const bytes = std::filesystem::file_size(entry.upload.file, error);
            if (!error)
                sizes.emplace_back(bytes, entry.upload.student);
        }
        std::stable_sort(sizes.begin(), sizes.end(), [](auto const& a, auto const& b) { return a.first > b.first; });
        line("\n{}", say(largest));
        for (std::size_t i = 0; i < std::min(shown, sizes.size()); ++i)
            line("  {:6.1f}  {}", double(sizes[i].first) / 1000, sizes[i].second);
    }

    void slow()
    {
        auto sorted = graded_;
        auto const ms = [](GradedUpload const* entry) {
            return entry->report.at("timing").at("total_ms").get<double>();
        };
        std::sort(sorted.begin(), sorted.end(),
                  [&](GradedUpload const* a, GradedUpload const* b) { return ms(a) > ms(b); });
        line("\n{}", say(slowest));
        for (std::size_t i = 0; i < std::min(shown, sorted.size()); ++i)
            line("  {:6.2f}  {}", ms(sorted[i]) / 1000, sorted[i]->upload.student);
    }

    std::vector<GradedUpload> const& entries_;
    std::vector<GradedUpload const*> graded_;
};
}  // namespace

std::string summary(std::vector<GradedUpload> const& entries, std::vector<std::string> const& remarks,
                    Language language)
{
    return SummaryPrinter(entries, language).print(remarks);
}
}  // namespace testat
