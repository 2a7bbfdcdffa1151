#include "bench/bench_report.h"
#include "report/printer.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat::bench {
namespace {
constexpr Term heading{"Laufzeit und Fehler von Texturfiltern: CPU-Zeit je Zugriff, Fehler zur Wahrheit",
                       "Run time and error of texture filters: CPU time of a lookup, error against truth"};
constexpr Term filter_term{"Filter", "filter"};
constexpr Term checker{"Schach", "checker"};
constexpr Term smooth{"weich", "smooth"};
constexpr Term noise{"Rauschen", "noise"};
constexpr Term front{"* auf der Pareto-Front des Schachbretts: keiner ist schneller und genauer",
                     "* on the checker's Pareto front: no filter is both faster and more accurate"};
constexpr Term caged{"Zeiten im Käfig misst die Sonde; vergleichbar ist die Referenz im Käfig.",
                     "Times in the cage are taken by the probe; compare with the caged reference."};
constexpr Term speed_up{"Trilinear, SSE, gegen die schlichte Referenz: {:.1f}-mal so schnell,\n{:.3f}-facher Fehler",
                        "trilinear, SSE, against the plain reference: {:.1f} times as fast,\n{:.3f} times its error"};
constexpr Term anisotropic{
    "Anisotrop, 4 Proben, gegen trilinear, SSE, auf dem Schachbrett:\n{:.2f}-facher RMSE "
    "(höchstens {:.2f} in einer Szene) in {:.2f}-facher Zeit",
    "anisotropic, 4 probes, against trilinear, SSE, on the checker:\n{:.2f} times its RMSE "
    "(at most {:.2f} in one scene) in {:.2f} times its time"};
constexpr Term float_heading{"Rundungsfehler in Einheiten der erlaubten Schranke, nach Größe von |u|, |v|",
                             "Float error in units of the allowed bound, by the size of |u| and |v|"};

class BenchPrinter : Printer {
public:
    BenchPrinter(Report const& document, Language language) : Printer(language), document_(document) {}

    std::string print()
    {
        if (!document_.at("upload").is_null())
            line("{}", text(document_.at("upload").at("file")));
        diagnostics();
        table();
        promises();
        float_errors();
        return std::move(out_);
    }

private:
    void diagnostics()
    {
        if (document_.at("upload").is_null() || document_.at("upload").at("build").at("ok").get<bool>())
            return;
        line("{}", say(does_not_build));
        auto const& all = document_.at("upload").at("build").at("diagnostics");
        for (std::size_t i = 0; i < std::min(shown_diagnostics, all.size()); ++i)
            line("  {}", diagnostic_line(all[i]));
    }

    static std::string shown(Report const& value, int digits)
    {
        return value.is_null() ? "-" : fmt::format("{:.{}f}", value.get<double>(), digits);
    }

    static std::string in_bounds(Report const& worst)
    {
        if (worst.is_null())
            return "∞";
        double const error = worst.get<double>();
        return error > 0 && error < 0.01 ? "<0.01" : fmt::format("{:.2f}", error);
    }

    std::string error(char const* pattern, std::string const& id) const
    {
        auto const& filters = document_.at("summary").at(pattern).at("filters");
        return filters.contains(id) ? shown(filters.at(id).at("rmse"), 4) : "-";
    }

    void table()
    {
        line("{}\n", say(heading));
        line("{:<31}{:>8}{:>10}{:>10}{:>10}{:>9}", say(filter_term), "ns", say(checker), say(smooth), say(noise), "ΔE");
        auto const& all = document_.at("summary").at("all").at("filters");
        auto const pareto = document_.at("summary").at("checker").at("pareto").get<std::vector<std::string>>();
        for (auto const& filter : document_.at("filters")) {
            std::string const id = text(filter.at("id"));
            if (!all.contains(id))
                continue;
            bool const best = std::find(pareto.begin(), pareto.end(), id) != pareto.end();
            line("{:<30}{}{:>8}{:>10}{:>10}{:>10}{:>9}", phrase(filter.at("title")), best ? "*" : " ",
                 shown(all.at(id).at("ns"), 1), error("checker", id), error("smooth", id), error("noise", id),
                 shown(all.at(id).at("delta_e"), 2));
        }
        line("\n{}", say(front));
        if (!document_.at("upload").is_null())
            line("{}", say(caged));
    }

    void promises()
    {
        auto const of = [&](char const* key) {
            Report const& value = document_.at("ratios").at(key);
            return value.is_null() ? 0.0 : value.get<double>();
        };
        line("");
        line(fmt::runtime(say(speed_up)), of("trilinear_speed_up"), of("trilinear_error"));
        line(fmt::runtime(say(anisotropic)), of("anisotropic_4_error"), of("anisotropic_4_worst_error"),
             of("anisotropic_4_time"));
    }

    void float_errors()
    {
        line("\n{}\n", say(float_heading));
        std::string head = fmt::format("{:<31}", say(filter_term));
        for (char const* limit : {"1", "10", "100", "1e3", "1e4", "1e5", "1e6"})
            head += fmt::format("{:>7}", limit);
        line("{}", head);
        for (auto const& filter : document_.at("filters")) {
            auto const& errors = document_.at("float_errors");
            if (!errors.contains(text(filter.at("id"))))
                continue;
            std::string row = fmt::format("{:<31}", phrase(filter.at("title")));
            for (auto const& worst : errors.at(text(filter.at("id"))))
                row += fmt::format("{:>7}", in_bounds(worst));
            line("{}", row);
        }
    }

    Report const& document_;
};
}  // namespace

std::string bench_to_text(Report const& document, Language language)
{
    return BenchPrinter(document, language).print();
}
}  // namespace testat::bench
