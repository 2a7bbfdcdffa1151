#include "report/printer.h"
#include "stress/stress_report.h"
#include "svg.h"

#include <algorithm>
#include <array>

namespace testat {
namespace {
constexpr Term title{"Numerischer Stress: Fehler in Einheiten der erlaubten Schranke",
                     "Numerical stress: error in units of the allowed bound"};
constexpr Term exact{"exakt", "exact"};
constexpr Term allowed{"erlaubt", "allowed"};
constexpr Term median_term{"Median", "median"};
constexpr Term most_term{"99,9 % der Eingaben", "99.9 % of the inputs"};
constexpr Term largest_term{"größter Fehler", "largest error"};
constexpr Term right_term{"richtig", "right"};
constexpr Term wrong_term{"falsch (Höhe: Anzahl, logarithmisch)", "wrong (height: how many, logarithmic)"};
constexpr Term not_asked{"nicht gefragt", "not asked"};

// Okabe and Ito's colours, which everybody can tell apart; the marks differ in shape as well.
constexpr char right_colour[] = "#0072b2";
constexpr char wrong_colour[] = "#d55e00";

// Pixels.
constexpr int width = 1000;
constexpr int left = 300;
constexpr int right = 960;
constexpr int top = 78;
constexpr int row_height = 44;
constexpr int exact_column = 64;  ///< for errors of zero, and as much for infinite ones
constexpr int axis_left = left + exact_column;
constexpr int axis_right = right - exact_column;

constexpr int tallest_bar = row_height - 14;

// Decades; bins are a tenth of one.
constexpr int first_decade = -5;
constexpr int last_decade = 4;
constexpr int bins_each = 10;
constexpr int bins = (last_decade - first_decade) * bins_each;

double x_of_logarithm(double logarithm)
{
    return axis_left + (logarithm - first_decade) / (last_decade - first_decade) * (axis_right - axis_left);
}

double x_of(double error)
{
    if (error == 0)
        return left + exact_column / 2.0;
    if (!(error < HUGE_VAL))
        return right - exact_column / 2.0;
    return x_of_logarithm(std::clamp(std::log10(error), double(first_decade), double(last_decade)));
}

/// How many errors are zero, in each bin, and infinite. What is off the axis counts at its end.
struct Histogram {
    std::uint64_t zero = 0;
    std::uint64_t infinite = 0;
    std::array<std::uint64_t, bins> counts{};
};

Histogram count(std::vector<float> const& errors)
{
    Histogram histogram;
    for (float error : errors) {
        if (error == 0)
            ++histogram.zero;
        else if (!(error < HUGE_VALF))
            ++histogram.infinite;
        else
            ++histogram.counts[std::size_t(
                std::clamp((std::log10(double(error)) - first_decade) * bins_each, 0.0, bins - 1.0))];
    }
    return histogram;
}

class Plot : Svg {
public:
    explicit Plot(Language language) : language_(language) {}

    std::string draw(std::vector<FunctionStress> const& results, std::string const& file)
    {
        bottom_ = top + row_height * static_cast<int>(results.size());
        int const height = bottom_ + 84;
        add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" lang="{2}" role="img" font-family="DejaVu Sans, Helvetica, Arial, sans-serif" font-size="14" fill="#222">)",
            width, height, say({"de", "en"}));
        add("<title>{}</title>", say(title));
        add(R"(<rect width="{}" height="{}" fill="#fff"/>)", width, height);
        label(20, 30, "start", say(title), R"( font-size="18" font-weight="bold")");
        label(20, 52, "start", file);
        axis();
        for (std::size_t i = 0; i < results.size(); ++i)
            row(results[i], top + row_height * static_cast<int>(i));
        bound();
        legend(bottom_ + 62);
        add("</svg>");
        return std::move(out_);
    }

private:
    char const* say(Term term) const { return testat::say(term, language_); }

    void axis()
    {
        constexpr char grid[] = R"(stroke="#ddd")";
        double const text_y = bottom_ + 20;
        for (int decade = first_decade; decade <= last_decade; ++decade) {
            double const x = x_of_logarithm(decade);
            line(x, top, x, bottom_, grid);
            power_of_ten(x, text_y, "middle", decade);
        }
        label(left + 4, text_y, "start", say(exact));
        label(x_of(HUGE_VAL), text_y, "middle", "∞");
    }

    /// The line that no correct function crosses.
    void bound()
    {
        double const x = x_of(1);
        line(x, top - 4, x, bottom_, R"(stroke="#000" stroke-width="2" stroke-dasharray="6 4")");
        label(x, top - 9, "middle", fmt::format("1 ({})", say(allowed)), R"( font-weight="bold")");
    }

    /// Logarithmic, so that one wrong answer of a million still shows.
    void bar(double x0, double x1, double floor, std::uint64_t count, std::uint64_t total, bool wrong)
    {
        if (count == 0)
            return;
        double const share = std::log1p(double(count)) / std::log1p(double(total));
        double const height = tallest_bar * share;
        add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}" fill-opacity="0.5"/>)", x0,
            floor - height, x1 - x0, height, wrong ? wrong_colour : right_colour);
    }

    void row(FunctionStress const& result, int y)
    {
        double const floor = y + row_height - 6;
        line(20, y + row_height, right, y + row_height, R"(stroke="#ccc")");
        label(left - 12, y + row_height / 2.0 + 5, "end", std::string(info(result.function).name));
        if (result.inside.errors.empty())
            return label(axis_left + 10, y + row_height / 2.0 + 5, "start", say(not_asked), R"( fill="#555")");
        Histogram const histogram = count(result.inside.errors);
        std::uint64_t const total = result.inside.errors.size();
        bar(left + 4, axis_left - 4, floor, histogram.zero, total, false);
        bar(axis_right + 4, right - 4, floor, histogram.infinite, total, true);
        for (int i = 0; i < bins; ++i) {
            double const logarithm = first_decade + double(i) / bins_each;
            bar(x_of_logarithm(logarithm), x_of_logarithm(logarithm + 1.0 / bins_each), floor,
                histogram.counts[std::size_t(i)], total, i >= -first_decade * bins_each);
        }
        double const middle = y + row_height / 2.0 + 6;
        median_mark(x_of(result.median), middle);
        most_mark(x_of(result.p999), middle);
        largest_mark(x_of(result.max), middle);
    }

    void median_mark(double x, double y) { line(x, y - 12, x, y + 10, R"(stroke="#000" stroke-width="4")"); }

    void most_mark(double x, double y)
    {
        add(R"(<path d="M{:.1f} {:.1f}l7 9l-7 9l-7 -9z" fill="#fff" stroke="#000" stroke-width="1.5"/>)", x, y - 9);
    }

    void largest_mark(double x, double y) { add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="5" fill="#000"/>)", x, y); }

    void legend(double y)
    {
        median_mark(30, y - 5);
        label(42, y, "start", say(median_term));
        most_mark(150, y - 5);
        label(164, y, "start", say(most_term));
        largest_mark(366, y - 5);
        label(378, y, "start", say(largest_term));
        bar(520, 544, y + 9, 1, 1, false);
        label(552, y, "start", say(right_term));
        bar(620, 644, y + 9, 1, 1, true);
        label(652, y, "start", say(wrong_term));
    }

    Language language_;
    int bottom_ = 0;
};
}  // namespace

std::string stress_to_svg(std::vector<FunctionStress> const& results, std::string const& file, Language language)
{
    return Plot(language).draw(results, file);
}
}  // namespace testat
