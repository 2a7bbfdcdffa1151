// The programs that run an upload know no answers: nothing of the judge is in the probe or the libraries it loads.
#include "end_to_end/testat_program.h"

#include "installation.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace testat {
namespace {
std::string output_of(std::vector<std::string> const& command)
{
    Command call;
    call.argv = command;
    Finished const finished = run(call);
    if (finished.exit_code != 0)
        throw std::runtime_error(command.at(0) + ": " + finished.output);
    return finished.output;
}

/// Functions of ours that a program, library or archive defines for others (mangled).
std::set<std::string> defined_by(std::filesystem::path const& file)
{
    std::istringstream lines(output_of({"nm", "--defined-only", "--format=posix", file.string()}));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, type;
        words >> name >> type;
        if (type == "T" && name.find("6testat") != std::string::npos)
            names.insert(name);
    }
    return names;
}

std::vector<std::filesystem::path> around_the_upload()
{
    auto const& where = installation();
    std::vector<std::filesystem::path> files{where.libraries / "probe", where.libraries / "libtestat_framework.so",
                                             where.libraries / "libtestat_trampolines.so"};
    for (auto const& entry : std::filesystem::directory_iterator(where.references))
        if (entry.path().extension() == ".so")
            files.push_back(entry.path());
    return files;
}

class AroundTheUpload : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(AroundTheUpload, DefinesNothingOfTheJudge)
{
    auto const judge = defined_by(TESTAT_JUDGE);
    EXPECT_GT(judge.size(), 50u);
    for (auto const& name : defined_by(GetParam()))
        EXPECT_EQ(judge.count(name), 0u) << name;
}

TEST_P(AroundTheUpload, HoldsNoWordsOfTheRubric)
{
    std::string const bytes = read_file(GetParam());
    Json const rubric = Json::parse(read_file(installation().rubric));
    for (auto const& [name, function] : rubric.at("functions").items())
        for (auto const& check : function.at("checks"))
            for (auto const& text : {check.at("name"), check.at("title").at("en"), check.at("hint").at("en")})
                EXPECT_EQ(bytes.find(text.get<std::string>()), std::string::npos) << text;
}

TEST_P(AroundTheUpload, LoadsNoLibraryOfTheJudge)
{
    std::string const libraries = output_of({"ldd", GetParam().string()});
    for (char const* library : {"gtest", "nettle", "valijson", "CLI", "judge", "OpenImageIO"})
        EXPECT_EQ(libraries.find(library), std::string::npos) << libraries;
}

INSTANTIATE_TEST_SUITE_P(Files, AroundTheUpload, testing::ValuesIn(around_the_upload()),
                         [](auto const& p) { return p.param.stem().string(); });

/// Otherwise the tests above would claim nothing.
TEST(Judge, IsFoundInTheProgramThatLinksIt)
{
    auto const judge = defined_by(TESTAT_JUDGE);
    int shared = 0;
    for (auto const& name : defined_by(TESTAT_PROGRAM))
        shared += judge.count(name) > 0 ? 1 : 0;
    EXPECT_GT(shared, 50);
    EXPECT_NE(output_of({"strings", TESTAT_PROGRAM}).find("EvaluateNearest."), std::string::npos);
}
}  // namespace
}  // namespace testat
