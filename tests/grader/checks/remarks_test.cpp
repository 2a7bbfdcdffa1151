#include "checks/remarks.h"

#include "reference_answers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
Textures const& textures()
{
    static Textures const made = make_test_textures(1);
    return made;
}

Observations answered(Request const& request)
{
    Observations observations;
    for (auto const& group : request.groups)
        observations.groups.emplace(group.name, reference_answers(group, textures()));
    return observations;
}

/// What the unit checks of these functions see of the reference.
Observations units_of(FunctionSet functions)
{
    Request request;
    for (auto const& check : unit_checks())
        if (functions.has(check.function)) {
            request.groups.push_back(questions_of(check, 1, textures()));
            request.groups.back().from_upload = FunctionSet::only(check.function);
        }
    return answered(request);
}

Request asked_again(Observations const& units)
{
    Request request;
    ask_again(request, units, textures());
    return request;
}

/// An upload with wrap_repeat alone, which is the reference's unless a test says otherwise.
class Remarks : public testing::Test {
protected:
    Answers& again() { return again_.groups.at("again/wrap_repeat"); }

    /// What the third round asks now, answered as the reference does it.
    void look_into_differences()
    {
        Request request;
        ask_about_differences(request, units_, again_, textures());
        differences_ = answered(request);
    }

    Answers& difference(std::string const& name) { return differences_.groups.at(name); }

    /// By id, each with its functions: "races wrap_repeat".
    std::vector<std::string> found() const
    {
        std::vector<std::string> all;
        for (auto const& remark : find_remarks(units_, again_, differences_)) {
            all.push_back(remark.id);
            for (Function f : remark.functions)
                all.back() += " " + std::string(info(f).name);
        }
        return all;
    }

    Observations units_ = units_of(FunctionSet::only(Function::wrap_repeat));
    Observations again_ = answered(asked_again(units_));
    Observations differences_;
};

using Ids = std::vector<std::string>;
std::string const check_name = "WrapRepeat.NegativeIndices";

/// Words of the first rendering, which has several threads.
void spoil_rendering(Answers& answers)
{
    ++answers.words[100];
}

/// Words of the second rendering, which has one.
void spoil_single(Answers& answers)
{
    ++answers.words[answers.group.words_per_answer + 100];
}
}  // namespace

TEST(AskAgain, AsksNothingWhereNothingWasAnswered)
{
    EXPECT_TRUE(asked_again({}).groups.empty());
    EXPECT_TRUE(asked_again({}).textures.empty());
}

TEST(AskAgain, ReversesAllQuestionsOfAFunction)
{
    Observations const units = units_of(FunctionSet::only(Function::wrap_clamp));
    Request const request = asked_again(units);
    ASSERT_EQ(request.groups.size(), 1u);
    Group const& again = request.groups[0];
    EXPECT_TRUE(again.twice);
    EXPECT_NE(again.fill, usual_fill);
    EXPECT_EQ(again.from_upload, FunctionSet::only(Function::wrap_clamp));
    std::uint32_t behind = again.count;
    for (auto const& [name, unit] : units.groups)
        for (std::uint32_t i = 0; i < unit.group.count; ++i)
            EXPECT_EQ(question<WrapQuestion>(again, --behind).val, question<WrapQuestion>(unit.group, i).val) << name;
    EXPECT_EQ(behind, 0u);
}

TEST(AskAgain, MakesWellFormedRequests)
{
    Request const request = asked_again(units_of(FunctionSet::all()));
    EXPECT_EQ(request.groups.size(), function_count);
    EXPECT_EQ(parse_request(serialize(request)).groups.size(), request.groups.size());
}

TEST(AskAgain, LeavesOutWhatDoesNotEndWell)
{
    for (Ended ended : {Ended::signal, Ended::timed_out, Ended::exception, Ended::lost}) {
        Observations units = units_of(FunctionSet::all());
        units.groups.at(check_name).status.ended = ended;
        EXPECT_EQ(asked_again(units).groups.size(), function_count - 1);
    }
}

TEST(AskAgain, LeavesOutWhatIsSlow)
{
    Observations units = units_of(FunctionSet::only(Function::wrap_repeat));
    units.groups.at(check_name).status.work_s = 1;
    EXPECT_TRUE(asked_again(units).groups.empty());
}

TEST_F(Remarks, AreNotMadeOfTheReference)
{
    units_ = units_of(FunctionSet::all());
    again_ = answered(asked_again(units_));
    look_into_differences();
    EXPECT_TRUE(differences_.groups.empty());
    EXPECT_EQ(found(), Ids{});
}

TEST_F(Remarks, TellStateBetweenCalls)
{
    ++again().words[0];
    look_into_differences();
    EXPECT_EQ(found(), Ids{"depends_on_earlier_calls wrap_repeat"});
}

TEST_F(Remarks, TellMemoryThatNobodyWroteTo)
{
    ++again().words.back();
    look_into_differences();
    ++difference("filled/" + check_name).words[0];
    EXPECT_EQ(found(), Ids{"differs_between_runs wrap_repeat"});
}

TEST_F(Remarks, TellACrashWithAnotherFill)
{
    again().status.ended = Ended::signal;
    look_into_differences();
    difference("filled/" + check_name).status.ended = Ended::signal;
    EXPECT_EQ(found(), Ids{"differs_between_runs wrap_repeat"});
}

TEST_F(Remarks, AreNotMadeWhereTheTimeRanOut)
{
    again().status.ended = Ended::timed_out;
    look_into_differences();
    EXPECT_EQ(found(), Ids{});

    again().status.ended = Ended::answered;
    ++again().words[0];
    look_into_differences();
    difference("filled/" + check_name).status.ended = Ended::timed_out;
    EXPECT_EQ(found(), Ids{}) << "which of the two reasons it is remains open";
}

TEST_F(Remarks, TellLeaks)
{
    again().status.kept = 32.0 * again().group.count;
    EXPECT_EQ(found(), Ids{"leaks wrap_repeat"});
}

TEST_F(Remarks, TakeNoSmallGrowthForALeak)
{
    for (double kept : {-1e6, 0.0, 1024.0}) {
        again().status.kept = kept;
        EXPECT_EQ(found(), Ids{}) << kept;
    }
}

TEST_F(Remarks, LookForRacesOnlyWhereVariablesAreWritten)
{
    look_into_differences();
    EXPECT_TRUE(differences_.groups.empty());
    again().status.wrote = 1;
    look_into_differences();
    EXPECT_EQ(difference("threads").group.from_upload, FunctionSet::only(Function::wrap_repeat));
    EXPECT_EQ(found(), Ids{});
}

TEST_F(Remarks, TellRaces)
{
    again().status.wrote = 1;
    look_into_differences();
    spoil_rendering(difference("threads"));
    EXPECT_EQ(found(), Ids{"races"});
    spoil_rendering(difference("threads/wrap_repeat"));
    EXPECT_EQ(found(), Ids{"races wrap_repeat"});
}

TEST_F(Remarks, TellRacesThatCrash)
{
    again().status.wrote = 1;
    look_into_differences();
    difference("threads").status.ended = Ended::signal;
    EXPECT_EQ(found(), Ids{"races"});
}

TEST_F(Remarks, TakeTimeThatIsUpForNoRace)
{
    again().status.wrote = 1;
    look_into_differences();
    difference("threads").status.ended = Ended::timed_out;
    spoil_rendering(difference("threads"));
    EXPECT_EQ(found(), Ids{});
}

TEST_F(Remarks, TakeNoDifferenceWithOneThreadForARace)
{
    again().status.wrote = 1;
    for (char const* name : {"threads", "threads/one", "threads/one_filled"}) {
        look_into_differences();
        spoil_rendering(difference("threads"));
        spoil_single(difference(name));
        EXPECT_EQ(found(), Ids{}) << name;
    }
}

TEST_F(Remarks, TakeNoCrashWithOneThreadForARace)
{
    again().status.wrote = 1;
    look_into_differences();
    for (char const* name : {"threads", "threads/one"})
        difference(name).status.ended = Ended::signal;
    EXPECT_EQ(found(), Ids{});
}

TEST_F(Remarks, SayNothingOfRacesWhereOneThreadIsNotSteadyEither)
{
    ++again().words[0];
    again().status.wrote = 1;
    look_into_differences();
    spoil_rendering(difference("threads"));
    EXPECT_EQ(found(), Ids{"depends_on_earlier_calls wrap_repeat"});
}

TEST_F(Remarks, HaveWordsInBothLanguages)
{
    again().status.kept = 1e6;
    for (auto const& remark : find_remarks(units_, again_, differences_)) {
        EXPECT_GT(remark.text.de.size(), 40u);
        EXPECT_GT(remark.text.en.size(), 40u);
    }
}
}  // namespace testat
