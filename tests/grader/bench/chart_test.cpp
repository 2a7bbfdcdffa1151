#include "bench/bench_report.h"
#include "bench/filters.h"
#include "bench/patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace testat::bench {
namespace {
/// Every tag that is opened is closed, in order.
bool is_balanced(std::string const& xml)
{
    std::vector<std::string> open;
    std::regex const tag("<(/?)([a-z]+)[^<>]*?(/?)>");
    for (std::sregex_iterator i(xml.begin(), xml.end(), tag), end; i != end; ++i) {
        std::smatch const& found = *i;
        if (found[1].length() == 0 && found[3].length() == 0)
            open.push_back(found[2]);
        if (found[1].length() == 0)
            continue;
        if (open.empty() || open.back() != found[2])
            return false;
        open.pop_back();
    }
    return open.empty();
}

BenchResults example()
{
    BenchResults results;
    for (auto const& filter : filters())
        results.filters.push_back({filter.id, filter.title, filter.family});
    results.filters.push_back({"upload_trilinear", {"trilinear, Abgabe", "trilinear, upload"}, Family::upload});
    for (auto const& pattern : patterns()) {
        Case one{"plane_0", pattern.id, 256, 100, {}};
        double size = 1;
        for (auto const& filter : results.filters)
            one.scores[filter.id] = {10 * ++size, 1 / size, size};
        results.cases.push_back(one);
    }
    results.float_errors = {{"fast_trilinear", {0, 0.1, 0.2, 0.3, 0.4, 0.5, 20}},
                            {"upload_trilinear", std::vector<double>(7, HUGE_VAL)}};
    return results;
}

TEST(BenchJson, HasItsKeys)
{
    Report const json = bench_to_json(example(), nullptr, nullptr);
    for (char const* key : {"schema_version", "upload", "picture_side", "rounds", "samples", "filters", "ratios",
                            "summary", "float_errors", "cases"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json.at("upload").is_null());
    for (char const* key : {"all", "checker", "smooth", "noise"})
        EXPECT_FALSE(json.at("summary").at(key).at("pareto").empty()) << key;
    EXPECT_EQ(json.at("cases").size(), 3u);
    EXPECT_EQ(json.at("cases")[0].at("filters").at("ewa").size(), 3u);
    EXPECT_GT(json.at("ratios").at("trilinear_speed_up"), 0);
    EXPECT_TRUE(json.at("float_errors").at("upload_trilinear")[0].is_null());
}

TEST(BenchJson, HasNullForWhatIsNotKnownOrNotFinite)
{
    BenchResults results = example();
    for (auto& one : results.cases)
        one.scores["upload_trilinear"] = {0, NAN, INFINITY};
    Report const score =
        bench_to_json(results, nullptr, nullptr).at("summary").at("all").at("filters").at("upload_trilinear");
    for (char const* key : {"ns", "rmse", "delta_e"})
        EXPECT_TRUE(score.at(key).is_null()) << key;
}

TEST(BenchSvg, IsWellFormedAndSelfContained)
{
    BenchResults results = example();
    results.cases[1].scores["upload_trilinear"] = {0, NAN, INFINITY};
    for (Language language : {Language::de, Language::en}) {
        std::string const svg = bench_to_svg(results, "a<b>&\".cpp", language);
        EXPECT_TRUE(is_balanced(svg)) << svg;
        EXPECT_EQ(svg.find("nan"), std::string::npos);
        EXPECT_EQ(svg.find("inf"), std::string::npos);
        EXPECT_EQ(svg.find("href"), std::string::npos);
        EXPECT_NE(svg.find("a&lt;b&gt;&amp;&quot;.cpp"), std::string::npos);
    }
}

/// Of UTF-8.
std::ptrdiff_t columns(std::string const& line)
{
    return std::count_if(line.begin(), line.end(),
                         [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
}

TEST(BenchText, KeepsTo80ColumnsInBothLanguages)
{
    Report const json = bench_to_json(example(), nullptr, nullptr);
    for (Language language : {Language::de, Language::en}) {
        std::string const text = bench_to_text(json, language);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(columns(line), 80) << line;
        EXPECT_NE(text.find("trilinear"), std::string::npos);
    }
}
}  // namespace
}  // namespace testat::bench
