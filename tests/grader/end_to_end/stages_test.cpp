// Stages know the data model and their own helpers, never each other.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace testat {
namespace {
using Names = std::set<std::string>;

Names const stages{"compile", "observe", "checks", "score", "report"};

/// What every stage may include.
Names const shared_files{"model.h", "answers.h", "functions.h", "installation.h", "text.h", "json_schema.h"};
Names const shared_folders{"process", "protocol", "sandbox", "rubric", "source", "envelopes"};

struct Include {
    std::filesystem::path file;
    std::string included;
};

std::vector<Include> includes_of(std::filesystem::path const& folder)
{
    std::vector<Include> found;
    std::regex const directive("#include \"([^\"]+)\"");
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::string const text = entry.is_regular_file() ? read_file(entry.path()) : "";
        for (std::sregex_iterator i(text.begin(), text.end(), directive), end; i != end; ++i)
            found.push_back({entry.path(), (*i)[1]});
    }
    return found;
}

bool may_include(std::string const& stage, std::string const& included)
{
    std::string const folder = included.substr(0, included.find('/'));
    if (folder == included)
        return shared_files.count(included) > 0;
    return folder == stage || shared_folders.count(folder) > 0;
}

class Stage : public testing::TestWithParam<std::string> {};

TEST_P(Stage, IncludesNoOtherStage)
{
    auto const includes = includes_of(std::filesystem::path(TESTAT_GRADER_SOURCES) / GetParam());
    EXPECT_FALSE(includes.empty());
    for (auto const& include : includes)
        EXPECT_TRUE(may_include(GetParam(), include.included)) << include.file << " includes " << include.included;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, Stage, testing::ValuesIn(stages), [](auto const& p) { return p.param; });

class SharedFolder : public testing::TestWithParam<std::string> {};

/// Otherwise a stage could reach another one through it.
TEST_P(SharedFolder, IncludesNoStage)
{
    for (auto const& include : includes_of(std::filesystem::path(TESTAT_GRADER_SOURCES) / GetParam()))
        EXPECT_EQ(stages.count(include.included.substr(0, include.included.find('/'))), 0u)
            << include.file << " includes " << include.included;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, SharedFolder, testing::ValuesIn(shared_folders),
                         [](auto const& p) { return p.param; });
}  // namespace
}  // namespace testat
