#include "stress/stress_report.h"

#include <gtest/gtest.h>

#include <regex>

namespace testat {
namespace {
Build good_build()
{
    Build build;
    build.ok = true;
    build.compiler = "g++ 12";
    return build;
}

FunctionStress with_errors(Function function, std::vector<float> errors)
{
    FunctionStress result;
    result.function = function;
    result.written = true;
    result.inside.counts.asked = errors.size();
    result.inside.errors = std::move(errors);
    summarize(result);
    return result;
}

Report json_of(std::vector<FunctionStress> const& results)
{
    return stress_to_json({"exercise_03.cpp", "", "abc", {}}, good_build(), {7, 0, false}, results);
}

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
}  // namespace

TEST(StressJson, HoldsWhatWasFound)
{
    FunctionStress result = with_errors(Function::wrap_clamp, {0, 0.25f, 0.5f});
    result.inside.counts.crashed = 2;
    result.inside.worst = Mismatch{"val = 1", "2", "3"};
    result.outside.counts.asked = 9;
    result.outside.counts.nan = 4;
    Report const json = json_of({result});
    EXPECT_EQ(json.at("schema_version"), 1);
    EXPECT_EQ(json.at("seed"), 7);
    EXPECT_EQ(json.at("sha256"), "abc");
    Report const& f = json.at("functions").at("wrap_clamp");
    EXPECT_EQ(f.at("asked"), 12);
    EXPECT_EQ(f.at("in_contract"), 3);
    EXPECT_EQ(f.at("median"), 0.25);
    EXPECT_EQ(f.at("max"), 0.5);
    EXPECT_EQ(f.at("wrong"), 0);
    EXPECT_EQ(f.at("crashed"), 2);
    EXPECT_EQ(f.at("worst_input"), "val = 1");
    EXPECT_EQ(f.at("outside").at("nan"), 4);
}

TEST(StressJson, HasNullForWhatIsNotFinite)
{
    Report const f = json_of({with_errors(Function::wrap_clamp, {0, HUGE_VALF})}).at("functions").at("wrap_clamp");
    EXPECT_TRUE(f.at("max").is_null());
    EXPECT_EQ(f.at("wrong"), 1);
    EXPECT_TRUE(json_of({with_errors(Function::wrap_clamp, {})}).at("functions").at("wrap_clamp").at("max").is_null());
}

TEST(StressSvg, IsWellFormedAndSelfContained)
{
    std::string const svg = stress_to_svg({with_errors(Function::wrap_clamp, {0, 1e-20f, 0.5f, 3, 1e20f, HUGE_VALF}),
                                           with_errors(Function::intersect, {})},
                                          "a<b>&\".cpp", Language::de);
    EXPECT_TRUE(is_balanced(svg)) << svg;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("href"), std::string::npos);
    EXPECT_NE(svg.find("a&lt;b&gt;&amp;&quot;.cpp"), std::string::npos);
    EXPECT_NE(svg.find(">wrap_clamp<"), std::string::npos);
    EXPECT_NE(svg.find("erlaubt"), std::string::npos);
}

TEST(StressSvg, SaysWhoWasNotAsked)
{
    std::string const svg = stress_to_svg({with_errors(Function::intersect, {})}, "f.cpp", Language::en);
    EXPECT_NE(svg.find("not asked"), std::string::npos);
}
}  // namespace testat
