// Texture lookups a second, and how many times as fast as the solution's of the same kind: all in one run, in random
// order, the least CPU time of nine counts.
//
//   cmake --build --preset release --target lookups_benchmark && build/release/tests/perf/lookups_benchmark
#include "bench/filters.h"
#include "bench/patterns.h"
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

namespace testat::bench {
namespace {
constexpr int repetitions = 9;
constexpr char baseline[] = "reference_trilinear";

/// The least seconds of CPU time of each benchmark, for all footprints once.
class Fastest : public benchmark::ConsoleReporter {
public:
    bool ReportContext(Context const& /*context*/) override { return true; }

    void ReportRuns(std::vector<Run> const& runs) override
    {
        for (Run const& run : runs) {
            if (run.run_type != Run::RT_Iteration)
                continue;
            auto const [found, is_new] =
                seconds_.try_emplace(run.run_name.function_name, std::numeric_limits<double>::infinity());
            found->second = std::min(found->second, run.cpu_accumulated_time / double(run.iterations));
        }
    }

    void print(std::size_t footprints) const
    {
        std::printf("%-24s %14s %10s\n", "filter", "million/s", "ratio");
        for (auto const& filter : filters())
            if (auto const found = seconds_.find(filter.id); found != seconds_.end())
                std::printf("%-24s %14.2f %10.2f\n", filter.id.c_str(), 1e-6 * double(footprints) / found->second,
                            seconds_.at(baseline) / found->second);
        std::printf("ratio: how many times as fast as %s\n", baseline);
    }

private:
    std::map<std::string, double> seconds_;
};

void look_up(benchmark::State& state, LookUp const& kernel, Footprints const& footprints)
{
    Colours colours(footprints.size());
    for (auto _ : state) {
        kernel(footprints.data(), footprints.size(), colours.data());
        benchmark::DoNotOptimize(colours.data());
        benchmark::ClobberMemory();
    }
}
}  // namespace
}  // namespace testat::bench

int main()
{
    using namespace testat::bench;
    int argc = 2;
    char name[] = "lookups_benchmark";
    char interleaved[] = "--benchmark_enable_random_interleaving=true";
    char* argv[] = {name, interleaved, nullptr};
    benchmark::Initialize(&argc, argv);
    View const view = look_at(scenes().front(), 128);
    auto const texture = make_texture(patterns().front(), 1024);
    for (auto const& filter : filters())
        benchmark::RegisterBenchmark(filter.id.c_str(),
                                     [kernel = filter.prepare(texture), &view](benchmark::State& state) {
                                         look_up(state, kernel, view.footprints);
                                     })
            ->MinTime(0.05)
            ->Repetitions(repetitions);
    Fastest fastest;
    benchmark::RunSpecifiedBenchmarks(&fastest);
    fastest.print(view.footprints.size());
    return 0;
}
