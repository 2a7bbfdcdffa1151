#include "bench/bench_report.h"
#include "bench/float_error.h"
#include "bench/patterns.h"
#include "report/printer.h"
#include "svg.h"

#include <algorithm>
#include <cmath>

namespace testat::bench {
namespace {
constexpr Term title{"Texturfilter: Laufzeit gegen Fehler", "Texture filters: run time against error"};
constexpr Term subtitle{
    "links unten ist besser; die Linie ist die Pareto-Front: kein Filter ist schneller und genauer",
    "lower left is better; the line is the Pareto front: no filter is both faster and more accurate"};
constexpr Term time_term{"ns je Zugriff", "ns for a lookup"};
constexpr Term error_term{"RMSE", "RMSE"};
constexpr Term float_term{"Rundungsfehler / erlaubte Schranke", "float error / allowed bound"};
constexpr Term size_term{"größtes |u|, |v|", "largest |u|, |v|"};
constexpr Term allowed{"erlaubt", "allowed"};
constexpr Term families[] = {{"Referenz (schlicht)", "reference (plain)"},
                             {"dasselbe mit SSE", "the same with SSE"},
                             {"jenseits des Blatts", "beyond the sheet"},
                             {"im Käfig: Abgabe, Referenz", "in the cage: upload, reference"}};

// Okabe and Ito's colours, which everybody can tell apart; families differ in shape and filters in number as well.
constexpr char const* colours[] = {"#555555", "#0072b2", "#b34700", "#007a56"};

// Pixels.
constexpr int width = 1160;
constexpr int margin = 62;
constexpr int panel_width = 320;
constexpr int panel_height = 340;
constexpr int panel_step = 364;
constexpr int top = 104;
constexpr int lower_top = top + panel_height + 84;
constexpr int row_height = 22;
constexpr double mark_radius = 9;

/// A logarithmic axis over whole decades.
struct Axis {
    int first;
    int last;
    double begin;  ///< pixel of the first decade
    double end;

    double at(double value) const
    {
        double const place = (std::log10(value) - first) / (last - first);
        return begin + std::clamp(place, 0.0, 1.0) * (end - begin);
    }
};

bool can_be_shown(Score const& score)
{
    return score.ns > 0 && score.rmse > 0 && std::isfinite(score.rmse);
}

/// Whole decades around all values.
class Range {
public:
    void add(double value)
    {
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }
    Axis axis(double begin, double end) const
    {
        int const first = least_ < HUGE_VAL ? static_cast<int>(std::floor(std::log10(least_))) : 0;
        int const last = most_ > 0 ? static_cast<int>(std::ceil(std::log10(most_))) : 1;
        return {first, std::max(last, first + 1), begin, end};
    }

private:
    double least_ = HUGE_VAL;
    double most_ = 0;
};

class Chart : Svg {
public:
    Chart(BenchResults const& results, Language language) : results_(results), language_(language)
    {
        for (auto const& pattern : patterns())
            panels_.push_back(mean_scores(results, pattern.id));
        for (auto const& scores : panels_)
            for (auto const& [id, score] : scores)
                if (can_be_shown(score)) {
                    times_.add(score.ns);
                    errors_.add(score.rmse);
                }
    }

    std::string draw(std::string const& file)
    {
        int const rows = static_cast<int>(results_.filters.size());
        int const height = lower_top + std::max(rows * row_height, 250) + 60;
        add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" lang="{2}" role="img" font-family="DejaVu Sans, Helvetica, Arial, sans-serif" font-size="13" fill="#222">)",
            width, height, say(Term{"de", "en"}));
        add("<title>{}</title>", say(title));
        add(R"(<rect width="{}" height="{}" fill="#fff"/>)", width, height);
        label(20, 30, "start", file.empty() ? say(title) : std::string(say(title)) + ": " + file,
              R"( font-size="18" font-weight="bold")");
        label(20, 52, "start", say(subtitle));
        for (std::size_t i = 0; i < panels_.size(); ++i)
            panel(i);
        legend();
        float_panel();
        add("</svg>");
        return std::move(out_);
    }

private:
    char const* say(Term term) const { return testat::say(term, language_); }
    char const* say(Title t) const { return testat::say(Term{t.de, t.en}, language_); }

    void frame(double left, double right, double above, double below)
    {
        add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="#888"/>)", left, above,
            right - left, below - above);
    }

    void grid(Axis const& x, Axis const& y, bool with_numbers)
    {
        constexpr char style[] = R"(stroke="#ddd")";
        for (int decade = x.first; decade <= x.last; ++decade) {
            double const at = x.at(std::pow(10.0, decade));
            line(at, y.end, at, y.begin, style);
            power_of_ten(at, y.begin + 26, "middle", decade);
        }
        for (int decade = y.first; decade <= y.last; ++decade) {
            double const at = y.at(std::pow(10.0, decade));
            line(x.begin, at, x.end, at, style);
            if (with_numbers)
                power_of_ten(x.begin - 8, at + 5, "end", decade);
        }
        frame(x.begin, x.end, y.end, y.begin);
    }

    void panel(std::size_t number)
    {
        double const left = margin + panel_step * static_cast<int>(number);
        Axis const x = times_.axis(left, left + panel_width);
        Axis const y = errors_.axis(top + panel_height, top);
        label(left + panel_width / 2.0, top - 12, "middle", say(patterns()[number].title), R"( font-weight="bold")");
        grid(x, y, number == 0);
        label(left + panel_width / 2.0, top + panel_height + 48, "middle", say(time_term));
        if (number == 0)
            label(left - 8, top - 12, "end", say(error_term));
        front(panels_[number], x, y);
        for (std::size_t i = 0; i < results_.filters.size(); ++i)
            if (auto const found = panels_[number].find(results_.filters[i].id);
                found != panels_[number].end() && can_be_shown(found->second))
                mark(i, x.at(found->second.ns), y.at(found->second.rmse));
    }

    /// Steps: what a front promises between two of its points is the less accurate one's error.
    void front(std::map<std::string, Score> const& scores, Axis const& x, Axis const& y)
    {
        std::string path;
        for (auto const& id : pareto_front(scores)) {
            Score const& score = scores.at(id);
            if (!can_be_shown(score))
                continue;
            path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x.at(score.ns), y.end)
                                 : fmt::format("H{:.1f}", x.at(score.ns));
            path += fmt::format("V{:.1f}", y.at(score.rmse));
        }
        if (!path.empty())
            add(R"(<path d="{}H{:.1f}" fill="none" stroke="#222" stroke-width="1.5" stroke-dasharray="5 3"/>)", path,
                x.end);
    }

    void mark(std::size_t filter, double x, double y)
    {
        shape(results_.filters[filter].family, x, y);
        add(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" font-size="10" font-weight="bold" fill="#fff">{}</text>)",
            x, y + 3.6, filter + 1);
    }

    void shape(Family family, double x, double y)
    {
        char const* colour = colours[static_cast<std::size_t>(family)];
        double const r = mark_radius;
        if (family == Family::reference)
            add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="{}" stroke="#fff"/>)", x, y, r, colour);
        else if (family == Family::fast)
            add(R"(<rect x="{:.1f}" y="{:.1f}" width="{}" height="{}" fill="{}" stroke="#fff"/>)", x - r + 1, y - r + 1,
                2 * r - 2, 2 * r - 2, colour);
        else if (family == Family::beyond)
            add(R"(<path d="M{0:.1f} {1:.1f}l{2} {2}l-{2} {2}l-{2} -{2}z" fill="{3}" stroke="#fff"/>)", x, y - r - 3,
                r + 3, colour);
        else
            add(R"(<path d="M{0:.1f} {1:.1f}l{2} 19l-{3} 0z" fill="{4}" stroke="#fff"/>)", x, y - r - 4, r + 3,
                2 * r + 6, colour);
    }

    void legend()
    {
        double y = lower_top;
        for (std::size_t i = 0; i < results_.filters.size(); ++i, y += row_height) {
            mark(i, margin, y);
            label(margin + 20, y + 5, "start", say(results_.filters[i].title));
        }
        y = lower_top;
        bool const has_upload = results_.filters.back().family == Family::upload;
        for (std::size_t i = 0; i < (has_upload ? 4u : 3u); ++i, y += row_height) {
            shape(static_cast<Family>(i), margin + 270, y);
            label(margin + 290, y + 5, "start", say(families[i]));
        }
    }

    /// From the smallest error that is not zero, but not more than six decades, to beyond the bound.
    Axis float_axis() const
    {
        double least = 1;
        for (auto const& [id, errors] : results_.float_errors)
            for (double error : errors)
                least = error > 0 ? std::min(least, error) : least;
        return {std::max(-6, static_cast<int>(std::floor(std::log10(least))) - 1), 1, lower_top + 230.0, lower_top};
    }

    void float_panel()
    {
        double const left = margin + panel_step + 220;
        double const right = margin + 2 * panel_step + panel_width;
        Axis const x{0, decades - 1, left, right};
        Axis const y = float_axis();
        label(left, lower_top - 12, "start", say(float_term), R"( font-weight="bold")");
        grid(x, y, true);
        label((left + right) / 2, y.begin + 48, "middle", say(size_term));
        line(left, y.at(1), right, y.at(1), R"(stroke="#000" stroke-width="2" stroke-dasharray="6 4")");
        label(right - 6, y.at(1) - 7, "end", std::string("1 (") + say(allowed) + ")");
        for (std::size_t i = 0; i < results_.filters.size(); ++i)
            if (auto const found = results_.float_errors.find(results_.filters[i].id);
                found != results_.float_errors.end())
                float_line(i, found->second, x, y);
    }

    void float_line(std::size_t filter, std::vector<double> const& errors, Axis const& x, Axis const& y)
    {
        std::string path;
        for (std::size_t i = 0; i < errors.size(); ++i)
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(std::pow(10.0, double(i))),
                                y.at(errors[i]));
        add(R"(<path d="{}" fill="none" stroke="{}"/>)", path,
            colours[static_cast<std::size_t>(results_.filters[filter].family)]);
        for (std::size_t i = 0; i < errors.size(); ++i)
            mark(filter, x.at(std::pow(10.0, double(i))), y.at(errors[i]));
    }

    BenchResults const& results_;
    Language language_;
    std::vector<std::map<std::string, Score>> panels_;
    Range times_;
    Range errors_;
};
}  // namespace

std::string bench_to_svg(BenchResults const& results, std::string const& file, Language language)
{
    return Chart(results, language).draw(file);
}
}  // namespace testat::bench
