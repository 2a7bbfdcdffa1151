// Grades every correct file of the corpus with both compilers at all their levels of optimisation, and every wrong one
// with both compilers; says what is graded otherwise than line 1 of the file demands, and how close the closest came.
#include "corpus/uploads.h"
#include "progress.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for_each.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <mutex>
#include <optional>

namespace {
using namespace testat;

struct Grading {
    Case upload;
    bool correct = false;
    std::string flags;  ///< "-O3,-march=native"; empty: as uploads are compiled

    std::string name() const { return fmt::format("{} ({} {})", upload.file.stem().string(), upload.compiler, flags); }
};

std::vector<Grading> all_gradings(bool quick)
{
    std::vector<std::string> levels{""};
    if (!quick)
        levels.insert(levels.end(), {"-O0", "-O2", "-O3", "-O3,-march=native,-ffp-contract=off",
                                     "-O3,-march=native,-ffp-contract=fast"});
    std::vector<Grading> all;
    for (auto const& upload : cases_in({"correct"}))
        for (auto const& flags : levels)
            all.push_back({upload, true, flags});
    for (auto const& upload : cases_in({"wrong"}))
        all.push_back({upload, false, ""});
    return all;
}

/// How far a grading is from the limit: at most 1 passes.
struct Measure {
    double value = 0;
    std::string what;

    void raise(double candidate, std::string const& where)
    {
        if (candidate > value)
            *this = {candidate, where};
    }
};

/// In units of what is allowed.
double error_of(Json const& check)
{
    if (check.at("error").is_number())
        return check.at("error").get<double>();
    return check.at("passed").get<bool>() ? 0 : HUGE_VAL;
}

double outside_of(Json const& picture)
{
    return picture.at("outside").get<double>() / std::max(1.0, picture.at("limit").get<double>());
}

/// The largest error, over checks and pictures of the functions that `counts`. A whole number that is wrong,
/// a value that is not finite and an answer that did not come are infinitely far off.
template <typename Counts>
Measure measure(Json const& report, Counts const& counts)
{
    Measure most;
    for (auto const& [name, function] : report.at("functions").items())
        for (auto const& check : function.at("checks"))
            if (counts(name))
                most.raise(error_of(check), check.at("name"));
    for (auto const& picture : report.at("pictures"))
        for (auto const& function : picture.at("functions"))
            if (counts(function.template get<std::string>()))
                most.raise(outside_of(picture), picture.at("name"));
    return most;
}

class Calibration {
public:
    void add(Grading const& grading, Json const& report)
    {
        std::lock_guard const lock(mutex_);
        Json const verdict = read_verdict(grading.upload.file);
        compare_points(grading, report, verdict);
        compare_names(grading, report, verdict);
        if (grading.correct)
            closest_correct(grading, measure(report, [](auto const&) { return true; }));
        else
            closest_wrong(grading, measure(report, [&](auto const& f) { return verdict.at("loses").contains(f); }));
    }

    void fail(Grading const& grading, std::string const& why)
    {
        std::lock_guard const lock(mutex_);
        complain(grading, why);
        ++not_graded_;
    }

    /// True if nothing is wrong.
    bool print() const
    {
        fmt::print("\n{:<28}{:>6} of {}\n", "false rejects", false_rejects_, correct_);
        fmt::print("{:<28}{:>6} of {}\n", "false accepts", false_accepts_, wrong_);
        fmt::print("{:<28}{:>6}\n", "collateral deductions", collateral_);
        fmt::print("{:<28}{:>6}\n", "outside the range of line 1", outside_range_);
        fmt::print("{:<28}{:>6} of {}, {} wrong\n", "mistakes named right", named_, to_be_named_, misnamed_);
        fmt::print("{:<28}{:>6}\n", "not gradable", not_graded_);
        fmt::print("closest correct: {:.3f} of what is allowed: {}\n", correct_side_.value, correct_side_.what);
        fmt::print("closest wrong:   {:.3f} times what is allowed: {}\n", wrong_side_.value, wrong_side_.what);
        return false_rejects_ + false_accepts_ + collateral_ + outside_range_ + misnamed_ + not_graded_ == 0 &&
               named_ >= 0.9 * to_be_named_;
    }

private:
    static void complain(Grading const& grading, std::string const& what)
    {
        fmt::print("{}: {}\n", grading.name(), what);
    }

    void compare_points(Grading const& grading, Json const& report, Json const& verdict)
    {
        ++(grading.correct ? correct_ : wrong_);
        bool rejected = false, accepted = false;
        for (auto const& [name, function] : report.at("functions").items()) {
            double const lost = function.at("max").get<double>() - function.at("earned").get<double>();
            bool const is_wrong = verdict.at("loses").contains(name);
            Json const range = verdict.at("loses").value(name, Json::array({0, 0}));
            bool const inside = lost >= range.at(0).get<double>() && lost <= range.at(1).get<double>();
            if (!inside)
                complain(grading, fmt::format("{} loses {} instead of {}", name, lost, range.dump()));
            outside_range_ += inside ? 0 : 1;
            rejected = rejected || (grading.correct && lost > 0);
            collateral_ += !grading.correct && !is_wrong && lost > 0 ? 1 : 0;
            accepted = accepted || (is_wrong && lost == 0 && range.at(1).get<double>() > 0);
        }
        false_rejects_ += rejected ? 1 : 0;
        false_accepts_ += accepted ? 1 : 0;
    }

    void compare_names(Grading const& grading, Json const& report, Json const& verdict)
    {
        Json const expected = verdict.value("mistake", Json::object());
        for (auto const& [name, function] : report.at("functions").items()) {
            Json const said = function.contains("mistake") ? function.at("mistake").at("id") : Json();
            Json const right = expected.value(name, Json());
            to_be_named_ += right.is_null() ? 0 : 1;
            named_ += !right.is_null() && said == right ? 1 : 0;
            misnamed_ += !said.is_null() && said != right ? 1 : 0;
            if (said != right)
                complain(grading, fmt::format("{} is called {} instead of {}", name, said.dump(), right.dump()));
        }
    }

    void closest_correct(Grading const& grading, Measure const& measure)
    {
        correct_side_.raise(measure.value, grading.name() + ", " + measure.what);
    }

    void closest_wrong(Grading const& grading, Measure const& measure)
    {
        if (measure.value > 0 && measure.value < wrong_side_.value)
            wrong_side_ = {measure.value, grading.name() + ", " + measure.what};
    }

    std::mutex mutex_;
    int correct_ = 0, wrong_ = 0;
    int false_rejects_ = 0, false_accepts_ = 0, collateral_ = 0, outside_range_ = 0;
    int named_ = 0, to_be_named_ = 0, misnamed_ = 0, not_graded_ = 0;
    Measure correct_side_;
    Measure wrong_side_{HUGE_VAL, "none"};
};

void grade_one(Grading const& grading, Calibration& calibration)
{
    TemporaryDirectory const place;
    std::vector<std::string> arguments{"--compiler", grading.upload.compiler};
    if (!grading.flags.empty())
        arguments.push_back("--compiler-flags=" + grading.flags);
    Graded const graded = grade_file(grading.upload.file, place.path(), arguments);
    if (graded.exit_code == 0 && graded.report.value("status", "") == "graded")
        calibration.add(grading, graded.report);
    else
        calibration.fail(grading, graded.err);
}
}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Grades the corpus with all compilers and flags, and says how sharp the grader is.", "calibrate");
    bool quick = false;
    int jobs = tbb::this_task_arena::max_concurrency();
    app.add_flag("--quick", quick, "Only the flags that uploads are compiled with");
    app.add_option("--jobs", jobs, "Grading at a time")->check(CLI::Range(1, 256))->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    tbb::global_control const limit(tbb::global_control::max_allowed_parallelism, std::size_t(jobs));
    auto const gradings = all_gradings(quick);
    Calibration calibration;
    Progress progress("Gradings", gradings.size());
    std::mutex mutex;
    tbb::parallel_for_each(gradings, [&](Grading const& grading) {
        grade_one(grading, calibration);
        std::lock_guard const lock(mutex);
        progress.step(grading.name());
    });
    return calibration.print() ? 0 : 1;
}
