#include "batch/overview.h"

#include "report/formats/page.h"
#include "report/reading.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace testat {
namespace {
constexpr char const html[] =
#include "batch/overview.mustache.inc"
    ;
constexpr char const style[] =
#include "batch/overview.css.inc"
    ;
constexpr char const script[] =
#include "batch/overview.js.inc"
    ;

std::string number(double value)
{
    return fmt::format("{:.2f}", value);
}

/// Nothing, if that is all there is.
Report some(std::string const& text)
{
    return text.empty() ? Report(nullptr) : Report(text);
}

bool is_overridden(Report const& report)
{
    auto const& functions = report.at("functions");
    return report.at("points").contains("override") ||
           std::any_of(functions.begin(), functions.end(), [](auto const& f) { return f.contains("override"); });
}

std::string address(std::string const& student)
{
    return "reports/" + url_part(student) + "/report.html";
}

/// Where bars of a histogram stand: as many as there are steps of `step` up to `max`, which belongs to the last one.
class Histogram {
public:
    Histogram(double max, double step) : max_(max), step_(step), counts_(std::size_t(std::ceil(max / step))) {}

    void add(double points)
    {
        if (!counts_.empty())
            ++counts_[std::min(counts_.size() - 1, std::size_t(std::max(0.0, points) / step_))];
    }

    /// In a box of 100 x 40 with the 60 % line at 60.
    Report view() const
    {
        Report bars = Report::array();
        double const most = double(*std::max_element(counts_.begin(), counts_.end()));
        double const width = 100 * step_ / max_;
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            double const height = most > 0 ? 34 * double(counts_[i]) / most : 0;
            bars.push_back({{"x", fmt::format("{:.2f}", width * double(i) + 0.1 * width)},
                            {"y", fmt::format("{:.2f}", 40 - height)},
                            {"w", fmt::format("{:.2f}", 0.8 * width)},
                            {"h", fmt::format("{:.2f}", height)},
                            {"left", fmt::format("{:.2f}", width * double(i))},
                            {"middle", fmt::format("{:.2f}", width * (double(i) + 0.5))},
                            {"above", fmt::format("{:.2f}", 38.8 - height)},
                            {"below", step_ * double(i + 1) <= 0.6 * max_ + 1e-9},
                            {"from", fmt::format("{:g}", step_ * double(i))},
                            {"count", counts_[i] > 0 ? Report(std::to_string(counts_[i])) : Report(nullptr)}});
        }
        return bars;
    }

private:
    double max_;
    double step_;
    std::vector<std::size_t> counts_;
};

class OverviewView {
public:
    OverviewView(std::vector<GradedUpload> const& entries, std::vector<SimilarPair> const& similar)
        : entries_(entries), similar_(similar)
    {
        for (auto const& entry : entries)
            if (entry.is_graded())
                graded_.push_back(&entry);
    }

    Report make()
    {
        Report view{{"counts", counts()}, {"rows", rows()}, {"groups", groups()}, {"columns", columns()}};
        view["has_groups"] = !view.at("groups").empty();
        view["width"] = std::to_string(view.at("columns").size() + 4);
        if (!graded_.empty()) {
            view["total"] = total();
            view["by_task"] = by_task();
        }
        return view;
    }

private:
    static double earned(GradedUpload const& entry) { return entry.report.at("points").at("earned"); }

    Report counts() const
    {
        double sum = 0;
        std::size_t passed = 0;
        for (auto const* entry : graded_) {
            sum += earned(*entry);
            passed += entry->report.at("points").at("passed_60_percent").get<bool>() ? 1 : 0;
        }
        Report view{{"uploads", std::to_string(entries_.size())},
                    {"graded", std::to_string(graded_.size())},
                    {"passed", std::to_string(passed)}};
        if (!graded_.empty())
            view["some"] = {{"mean", number(sum / double(graded_.size()))},
                            {"max", number(graded_.front()->report.at("points").at("max"))},
                            {"percent", fmt::format("{:.0f}", 100 * double(passed) / double(graded_.size()))}};
        return view;
    }

    Report columns() const
    {
        Report all = Report::array();
        if (!graded_.empty())
            for (auto const& task : graded_.front()->report.at("tasks"))
                all.push_back({{"id", task.at("id")}, {"most", fmt::format("{:g}", task.at("max").get<double>())}});
        return all;
    }

    Report total() const
    {
        constexpr double step = 1;
        Histogram histogram(graded_.front()->report.at("points").at("max"), step);
        for (auto const* entry : graded_)
            histogram.add(earned(*entry));
        double const max = graded_.front()->report.at("points").at("max");
        return {{"bars", histogram.view()}, {"most", fmt::format("{:g}", max)}};
    }

    Report by_task() const
    {
        constexpr double step = 0.5;
        Report all = Report::array();
        auto const& tasks = graded_.front()->report.at("tasks");
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            double const max = tasks.at(i).at("max");
            double sum = 0;
            Histogram histogram(max, std::max(step, max / 8));
            for (auto const* entry : graded_) {
                double const points = entry->report.at("tasks").at(i).at("earned");
                sum += points;
                histogram.add(points);
            }
            all.push_back({{"id", tasks.at(i).at("id")},
                           {"number", std::to_string(i)},
                           {"title", tasks.at(i).at("title")},
                           {"mean", number(sum / double(graded_.size()))},
                           {"max", number(max)},
                           {"most", fmt::format("{:g}", max)},
                           {"bars", histogram.view()}});
        }
        return all;
    }

    Report rows() const
    {
        Report all = Report::array();
        for (auto const& entry : entries_)
            all.push_back(row(entry));
        return all;
    }

    Report row(GradedUpload const& entry) const
    {
        auto const& upload = entry.upload;
        bool const has_name = !upload.lastname.empty() || !upload.firstname.empty();
        Report view{
            {"student",
             has_name ? upload.lastname + (upload.firstname.empty() ? "" : ", " + upload.firstname) : upload.student},
            {"login", some(upload.logins.empty() ? upload.login : fmt::format("{}", fmt::join(upload.logins, " ")))},
            {"link", address(upload.student)},
            {"marks", marks(entry)},
            {"state", states(entry)},
            {"team", some(upload.team)}};
        if (entry.is_graded())
            add_points(view, entry.report);
        else
            add_nothing(view, entry.report);
        return view;
    }

    static void add_points(Report& view, Report const& report)
    {
        Report cells = Report::array();
        std::string lost;
        for (auto const& task : report.at("tasks")) {
            double const points = task.at("earned");
            double const max = task.at("max");
            if (points < max)
                lost += " " + task.at("id").get<std::string>();
            cells.push_back({{"points", number(points)}, {"full", points >= max}, {"zero", points <= 0}});
        }
        view["cells"] = cells;
        view["lost"] = lost;
        view["sum"] = number(report.at("points").at("earned"));
        view["passed"] = report.at("points").at("passed_60_percent");
        Report mistakes = Report::array();
        for (auto const& [name, function] : report.at("functions").items())
            if (function.contains("mistake"))
                mistakes.push_back({{"id", function.at("mistake").at("id")}});
        view["mistakes"] = mistakes;
    }

    void add_nothing(Report& view, Report const& report) const
    {
        view["cells"] = Report::array();
        for (std::size_t i = 0; i < columns().size(); ++i)
            view["cells"].push_back({{"points", ""}, {"full", false}, {"zero", false}});
        view["lost"] = "";
        view["sum"] = "";
        view["passed"] = false;
        view["mistakes"] = Report::array();
        view["why"] = one_line(report.at("error").get<std::string>(), 200);
    }

    /// Words for the filter: what a row counts as.
    static std::vector<std::string> words_of(GradedUpload const& entry, bool similar)
    {
        std::vector<std::string> all;
        auto const add = [&](bool applies, char const* word) {
            if (applies)
                all.emplace_back(word);
        };
        add(entry.upload.late, "late");
        add(similar, "similar");
        add(!entry.is_graded(), "ungradable");
        if (!entry.is_graded())
            return all;
        bool const passed = entry.report.at("points").at("passed_60_percent");
        add(passed, "passed");
        add(!passed, "failed");
        add(is_overridden(entry.report), "overridden");
        add(!entry.report.at("build").at("ok").get<bool>(), "broken");
        add(Reading(entry.report).applies("crashes"), "crashes");
        return all;
    }

    std::string states(GradedUpload const& entry) const
    {
        return fmt::format("{}", fmt::join(words_of(entry, is_similar(entry)), " "));
    }

    Report marks(GradedUpload const& entry) const
    {
        Report view = Report::object();
        for (char const* mark : {"late", "similar", "ungradable", "overridden", "broken", "crashes"})
            view[mark] = false;
        for (auto const& word : words_of(entry, is_similar(entry)))
            view[word] = true;
        return view;
    }

    bool is_similar(GradedUpload const& entry) const
    {
        return std::any_of(similar_.begin(), similar_.end(), [&](SimilarPair const& pair) {
            return pair.first == entry.upload.student || pair.second == entry.upload.student;
        });
    }

    /// One comment serves many. The largest group first.
    Report groups() const
    {
        std::map<std::string, Report> found;
        for (auto const* entry : graded_)
            for (auto const& [name, function] : entry->report.at("functions").items())
                if (function.contains("mistake"))
                    add_to(found[function.at("mistake").at("id").get<std::string>()], name, function, entry->upload);
        std::vector<Report> sorted;
        for (auto& [id, group] : found) {
            group["size"] = std::to_string(group.at("who").size());
            sorted.push_back(group);
        }
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](auto const& a, auto const& b) { return a.at("who").size() > b.at("who").size(); });
        return sorted;
    }

    static void add_to(Report& group, std::string const& name, Report const& function, Upload const& upload)
    {
        Report const& mistake = function.at("mistake");
        group["id"] = mistake.at("id");
        group["of_function"] = name;
        group["said"] = {{"de", mistake.at("de")}, {"en", mistake.at("en")}};
        group["who"].push_back({{"name", upload.student}, {"href", address(upload.student)}});
    }

    std::vector<GradedUpload> const& entries_;
    std::vector<SimilarPair> const& similar_;
    std::vector<GradedUpload const*> graded_;
};
}  // namespace

std::string overview_page(std::vector<GradedUpload> const& entries, std::vector<SimilarPair> const& similar,
                          std::string const& title, Language language)
{
    static Page const page(html, style, script);
    Report view = OverviewView(entries, similar).make();
    view["german"] = language == Language::de;
    view["title_of_batch"] = one_line(title);
    view["compared"] = !similar.empty();
    return page.render(std::move(view));
}
}  // namespace testat
