#include "bench/bench.h"

#include <algorithm>
#include <cmath>

namespace testat::bench {
namespace {
std::vector<Case const*> cases_with(BenchResults const& results, std::string const& pattern)
{
    std::vector<Case const*> found;
    for (auto const& one : results.cases)
        if (pattern.empty() || one.pattern == pattern)
            found.push_back(&one);
    return found;
}

bool is_in_all(std::string const& filter, std::vector<Case const*> const& cases)
{
    return !cases.empty() &&
           std::all_of(cases.begin(), cases.end(), [&](Case const* one) { return one->scores.count(filter) > 0; });
}

Score mean_of(std::string const& filter, std::vector<Case const*> const& cases)
{
    Score sum;
    double pixels = 0;
    bool is_timed = true;
    for (Case const* one : cases) {
        Score const& score = one->scores.at(filter);
        is_timed = is_timed && score.ns > 0;
        sum.ns += score.ns * double(one->pixels);
        pixels += double(one->pixels);
        sum.rmse += score.rmse * score.rmse;
        sum.delta_e += score.delta_e;
    }
    double const count = double(cases.size());
    return {is_timed ? sum.ns / pixels : 0, std::sqrt(sum.rmse / count), sum.delta_e / count};
}

bool can_be_shown(Score const& score)
{
    return score.ns > 0 && std::isfinite(score.rmse);
}

bool beats(Score const& a, Score const& b)
{
    return a.ns <= b.ns && a.rmse <= b.rmse && (a.ns < b.ns || a.rmse < b.rmse);
}
}  // namespace

std::map<std::string, Score> mean_scores(BenchResults const& results, std::string const& pattern)
{
    std::map<std::string, Score> means;
    auto const cases = cases_with(results, pattern);
    for (auto const& filter : results.filters)
        if (is_in_all(filter.id, cases))
            means[filter.id] = mean_of(filter.id, cases);
    return means;
}

std::vector<std::string> pareto_front(std::map<std::string, Score> const& scores)
{
    std::vector<std::string> front;
    for (auto const& [id, score] : scores) {
        bool const is_beaten = std::any_of(scores.begin(), scores.end(), [&, &mine = score](auto const& other) {
            return can_be_shown(other.second) && beats(other.second, mine);
        });
        if (can_be_shown(score) && !is_beaten)
            front.push_back(id);
    }
    std::sort(front.begin(), front.end(),
              [&](auto const& a, auto const& b) { return scores.at(a).ns < scores.at(b).ns; });
    return front;
}

Ratios ratios(BenchResults const& results)
{
    auto const all = mean_scores(results);
    auto const checker = mean_scores(results, "checker");
    Ratios found;
    found.trilinear_speed_up = all.at("reference_trilinear").ns / all.at("fast_trilinear").ns;
    found.trilinear_error = all.at("fast_trilinear").rmse / all.at("reference_trilinear").rmse;
    found.anisotropic_error = checker.at("anisotropic_4").rmse / checker.at("fast_trilinear").rmse;
    found.anisotropic_time = checker.at("anisotropic_4").ns / checker.at("fast_trilinear").ns;
    for (Case const* one : cases_with(results, "checker"))
        found.worst_anisotropic_error =
            std::max(found.worst_anisotropic_error,
                     one->scores.at("anisotropic_4").rmse / one->scores.at("fast_trilinear").rmse);
    return found;
}
}  // namespace testat::bench
