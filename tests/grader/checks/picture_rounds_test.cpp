#include "checks/picture_rounds.h"

#include "envelopes/envelope.h"
#include "example_grading.h"
#include "installation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace testat {
namespace {
/// What the real rubric asks of a file whose unit checks all pass.
class PictureRounds : public testing::Test {
protected:
    PictureRounds() : rubric_(read_rubric(installation().rubric)), results_(passed_results(rubric_))
    {
        for (auto& picture : results_.pictures)
            for (auto& isolated : picture.isolated)
                isolated.rendering.reset();
    }

    void fail(std::string const& check) { find_result(results_, check).passed = false; }

    PictureResult& picture(std::string const& name)
    {
        return *std::find_if(results_.pictures.begin(), results_.pictures.end(),
                             [&](auto const& p) { return p.name == name; });
    }

    static std::set<std::string> names(Request const& request)
    {
        std::set<std::string> found;
        for (auto const& group : request.groups)
            found.insert(group.name);
        return found;
    }

    static Group find_group(Request const& request, std::string const& name)
    {
        auto const found = std::find_if(request.groups.begin(), request.groups.end(),
                                        [&](auto const& group) { return group.name == name; });
        return found == request.groups.end() ? Group{} : *found;
    }

    static bool culling(Request const& request, std::string const& name) { return find_group(request, name).culling; }

    Rubric rubric_;
    CheckResults results_;
    Build build_ = whole_build();
};
}  // namespace

TEST_F(PictureRounds, AskForEveryPictureAsSubmitted)
{
    Request const request = ask_submitted(rubric_, results_, build_);
    EXPECT_EQ(request.groups.size(), pictures_of(rubric_).size());
    for (auto const& group : request.groups) {
        EXPECT_EQ(group.from_upload, FunctionSet::all());
        EXPECT_TRUE(group.culling) << group.name;
    }
}

TEST_F(PictureRounds, MakeNothingOfAFileThatDoesNotLink)
{
    build_.ok = false;
    EXPECT_TRUE(ask_submitted(rubric_, results_, build_).groups.empty());
}

TEST_F(PictureRounds, IsolateNothingWhereAllIsRight)
{
    EXPECT_TRUE(ask_isolated(rubric_, results_, build_).groups.empty());
    EXPECT_TRUE(ask_repaired(results_, FunctionSet::all()).groups.empty());
}

TEST_F(PictureRounds, IsolateWhatFailsAUnitCheck)
{
    fail("TransformPosition.RigidMotions");
    EXPECT_EQ(names(ask_isolated(rubric_, results_, build_)),
              (std::set<std::string>{"isolated/goboard_after_e/transform_position",
                                     "isolated/pooltable_after_e/transform_position"}));
}

TEST_F(PictureRounds, IsolateEachFunctionOfAPictureThatIsWrongAsSubmitted)
{
    picture("goboard_after_e").submitted->comparison.score = 0.5;
    EXPECT_EQ(
        names(ask_isolated(rubric_, results_, build_)),
        (std::set<std::string>{"isolated/goboard_after_e/transform_direction",
                               "isolated/goboard_after_e/transform_position", "isolated/goboard_after_e/intersect"}));
}

TEST_F(PictureRounds, AskOnceForAllThatIsNotSuspected)
{
    fail("TransformPosition.RigidMotions");
    picture("goboard_after_e").submitted->comparison.score = 0.5;
    Request const request = ask_isolated(rubric_, results_, build_);
    EXPECT_EQ(names(request), (std::set<std::string>{"isolated/goboard_after_e/transform_position",
                                                     "isolated/pooltable_after_e/transform_position",
                                                     "without_suspects/goboard_after_e"}));
    EXPECT_EQ(find_group(request, "without_suspects/goboard_after_e").from_upload,
              FunctionSet::all().without(Function::transform_position));
}

TEST_F(PictureRounds, IsolateTheRestOfWhatIsWrongWithoutItsSuspects)
{
    fail("TransformPosition.RigidMotions");
    PictureResult& goboard = picture("goboard_after_e");
    goboard.submitted->comparison.score = 0.5;
    judge_isolated(results_, {}, installation());
    EXPECT_EQ(
        names(ask_isolated(rubric_, results_, build_)),
        (std::set<std::string>{"isolated/goboard_after_e/transform_direction", "isolated/goboard_after_e/intersect"}));
    EXPECT_TRUE(ask_repaired(results_, FunctionSet::all()).groups.empty()) << "it is known without the one suspect";
}

TEST_F(PictureRounds, IsolateNothingMoreWhereAPictureIsRightWithoutItsSuspects)
{
    fail("TransformPosition.RigidMotions");
    PictureResult& goboard = picture("goboard_after_e");
    goboard.submitted->comparison.score = 0.5;
    Group const group = find_group(ask_isolated(rubric_, results_, build_), "without_suspects/goboard_after_e");
    Answers answers{group, {}, std::vector<std::uint32_t>(group.answer_size())};
    answers.status.ended = Ended::answered;
    auto const rgb = read_envelope(installation().envelopes / "goboard_after_e.envelope").expected.rgb;
    ASSERT_EQ(rgb.size(), answers.words.size());
    std::memcpy(answers.words.data(), rgb.data(), rgb.size() * sizeof rgb[0]);
    Observations observations;
    observations.groups.emplace(group.name, std::move(answers));
    judge_isolated(results_, observations, installation());
    EXPECT_TRUE(ask_isolated(rubric_, results_, build_).groups.empty());
    for (auto const& isolated : goboard.isolated)
        EXPECT_EQ(isolated.score, isolated.function == Function::transform_position ? 0 : 1);
}

TEST_F(PictureRounds, IsolateOnlyWhatIsDefined)
{
    fail("TransformPosition.RigidMotions");
    build_.defined = build_.defined.without(Function::transform_position);
    EXPECT_TRUE(ask_isolated(rubric_, results_, build_).groups.empty());
}

TEST_F(PictureRounds, CullOnlyWhatFindsHitsRightly)
{
    fail("TransformPosition.RigidMotions");
    Request const submitted = ask_submitted(rubric_, results_, build_);
    EXPECT_FALSE(culling(submitted, "submitted/goboard_after_e"));
    EXPECT_FALSE(culling(submitted, "submitted/sphere_after_f"));
    EXPECT_TRUE(culling(submitted, "submitted/goboard_after_c")) << "nothing is transformed there";
    EXPECT_FALSE(culling(ask_isolated(rubric_, results_, build_), "isolated/goboard_after_e/transform_position"));
}

TEST_F(PictureRounds, CullOnlyWhereIntersectIsRightWithoutTransforms)
{
    fail("Intersect.TransformsOff");
    EXPECT_FALSE(culling(ask_submitted(rubric_, results_, build_), "submitted/plane_after_c"));
}

TEST_F(PictureRounds, RememberWhatHasRunIntoTheLimit)
{
    EXPECT_EQ(ask_submitted(rubric_, results_, build_).hanging, FunctionSet());
    find_result(results_, "TangentSpace.LengthIsOne").ended = Ended::timed_out;
    fail("TangentSpace.LengthIsOne");
    auto const hanging = FunctionSet::only(Function::transform_direction_to_object_space);
    EXPECT_EQ(ask_submitted(rubric_, results_, build_).hanging, hanging);
    EXPECT_EQ(ask_isolated(rubric_, results_, build_).hanging, hanging);
}

TEST_F(PictureRounds, RepairWhatIsWrongAsSubmitted)
{
    fail("WrapRepeat.NegativeIndices");
    fail("EvaluateNearest.UpperFractions");
    picture("plane_after_c").submitted->comparison.score = 0;
    EXPECT_EQ(names(ask_repaired(results_, FunctionSet::all())),
              (std::set<std::string>{"repaired/plane_after_c/none", "repaired/plane_after_c/wrap_repeat",
                                     "repaired/plane_after_c/evaluate_nearest"}));
}

TEST_F(PictureRounds, RepairNothingToSeeWhatIsKnown)
{
    for (auto const& function : rubric_.functions)
        fail(function.checks.front().name);
    for (auto& picture : results_.pictures)
        picture.submitted->comparison.score = 0;
    EXPECT_TRUE(ask_repaired(results_, FunctionSet()).groups.empty());
    explain(results_, FunctionSet(), {}, installation());
    EXPECT_EQ(picture("plane_after_b_clamp").explained_by,
              (std::vector<std::string>{"evaluate_nearest", "wrap_clamp"}));
}
}  // namespace testat
