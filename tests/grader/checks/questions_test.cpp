#include "checks/run_checks.h"
#include "installation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
Rubric const& rubric()
{
    static Rubric const read = read_rubric(installation().rubric);
    return read;
}

Group const* find_group(Questions const& questions, std::string const& name)
{
    for (auto const& group : questions.request.groups)
        if (group.name == name)
            return &group;
    return nullptr;
}
}  // namespace

TEST(MakeQuestions, AsksEveryCheckIsolated)
{
    Questions const questions = make_questions(rubric(), FunctionSet::all(), 1);
    for (auto const& function : rubric().functions)
        for (auto const& check : function.checks) {
            Group const* group = find_group(questions, check.name);
            ASSERT_NE(group, nullptr) << check.name;
            EXPECT_EQ(group->from_upload, FunctionSet::only(function.function)) << check.name;
            EXPECT_EQ(group->under_test, function.function) << check.name;
        }
}

TEST(MakeQuestions, HaveNamesOfTheirOwn)
{
    std::set<std::string> names;
    for (auto const& group : make_questions(rubric(), FunctionSet::all(), 1).request.groups)
        EXPECT_TRUE(names.insert(group.name).second) << group.name;
}

TEST(MakeQuestions, AsksNothingOfWhatIsMissing)
{
    auto const available = FunctionSet::all().without(Function::wrap_repeat);
    Questions const questions = make_questions(rubric(), available, 1);
    EXPECT_EQ(find_group(questions, "WrapRepeat.InsideTheRange"), nullptr);
    EXPECT_NE(find_group(questions, "WrapClamp.InsideTheRange"), nullptr);
}

TEST(MakeQuestions, AsksACheckTheSameWhateverElseIsAsked)
{
    Questions const all = make_questions(rubric(), FunctionSet::all(), 5);
    for (char task : {'a', 'b', 'c', 'd', 'e', 'f'})
        for (auto const& group : make_questions(only_tasks(rubric(), {task}), FunctionSet::all(), 5).request.groups)
            EXPECT_EQ(group.questions, find_group(all, group.name)->questions) << group.name;
}

TEST(MakeQuestions, NamesTheTestSetByItsContent)
{
    auto const name = [](FunctionSet available, std::uint64_t seed) {
        return make_questions(rubric(), available, seed).sha256;
    };
    std::string const one = name(FunctionSet::all(), 1);
    EXPECT_EQ(one.size(), 64u);
    EXPECT_EQ(name(FunctionSet(), 1), one) << "whatever an upload lacks";
    EXPECT_NE(name(FunctionSet::all(), 2), one);
    Rubric fewer_pictures = rubric();
    fewer_pictures.functions[0].pictures.pop_back();
    EXPECT_NE(make_questions(fewer_pictures, FunctionSet::all(), 1).sha256, one);
}

TEST(MakeQuestions, NamesTheTestSetTheSameForEveryUpload)
{
    Questions const one = make_questions(rubric(), FunctionSet::all(), 1, "one");
    Questions const other = make_questions(rubric(), FunctionSet::all(), 1, "other");
    EXPECT_EQ(one.sha256, other.sha256);
    EXPECT_NE(serialize(one.request), serialize(other.request));
    EXPECT_EQ(serialize(one.request), serialize(make_questions(rubric(), FunctionSet::all(), 1, "one").request));
}

TEST(MakeQuestions, RefusesChecksThatAreNotThere)
{
    Rubric wrong = rubric();
    wrong.functions[0].checks[0].name = "EvaluateNearest.NoSuchCheck";
    EXPECT_THROW(make_questions(wrong, FunctionSet::all(), 1), BadRubric);
}

TEST(MakeQuestions, CanBeSent)
{
    Questions const questions = make_questions(rubric(), FunctionSet::all(), 1);
    EXPECT_EQ(parse_request(serialize(questions.request)).groups.size(), questions.request.groups.size());
}

}  // namespace testat
