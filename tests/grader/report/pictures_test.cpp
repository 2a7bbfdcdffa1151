#include "report/pictures.h"

#include "example_grading.h"
#include "grey_picture.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace testat {
namespace {
PictureResult right_picture()
{
    return passed_results(example_rubric()).pictures[0];
}

PictureResult wrong_picture()
{
    PictureResult picture = right_picture();
    picture.submitted.value().picture.value().rgb[0] = 0.9f;
    return picture;
}

float brightness(Picture const& picture, std::size_t pixel)
{
    return picture.rgb[3 * pixel] + picture.rgb[3 * pixel + 1] + picture.rgb[3 * pixel + 2];
}

std::set<std::string> files_in(std::filesystem::path const& directory)
{
    std::set<std::string> names;
    for (auto const& entry : std::filesystem::directory_iterator(directory))
        names.insert(entry.path().filename().string());
    return names;
}
}  // namespace

TEST(PictureFile, IsSharedIfItIsRight)
{
    EXPECT_EQ(picture_file(right_picture(), PictureKind::expected), "pictures/clamped.expected.png");
    EXPECT_EQ(picture_file(right_picture(), PictureKind::isolated), "pictures/clamped.expected.png");
    EXPECT_EQ(picture_file(right_picture(), PictureKind::submitted), "pictures/clamped.expected.png");
    EXPECT_EQ(picture_file(right_picture(), PictureKind::difference), std::nullopt);
}

TEST(PictureFile, IsItsOwnIfItDiffersByABit)
{
    PictureResult picture = right_picture();
    picture.submitted.value().picture.value().rgb[0] = std::nextafter(0.5f, 1.f);
    EXPECT_EQ(picture_file(picture, PictureKind::submitted), "pictures/clamped.submitted.png");
    EXPECT_EQ(picture_file(picture, PictureKind::difference), "pictures/clamped.difference.png");
    EXPECT_EQ(picture_file(picture, PictureKind::isolated), "pictures/clamped.expected.png");
}

TEST(PictureFile, IsNoneIfItWasNotMade)
{
    PictureResult picture = right_picture();
    picture.isolated[0].rendering = Rendering{};
    picture.submitted.reset();
    EXPECT_EQ(picture_file(picture, PictureKind::isolated), std::nullopt);
    EXPECT_EQ(picture_file(picture, PictureKind::difference), std::nullopt);
    EXPECT_TRUE(picture_file(picture, PictureKind::expected));
}

TEST(PictureFile, IsThatOfTheSubmittedOneWhereNothingHadToBeIsolated)
{
    PictureResult picture = wrong_picture();
    picture.isolated[0].rendering.reset();
    EXPECT_EQ(picture_file(picture, PictureKind::isolated), "pictures/clamped.isolated.png");
}

TEST(PictureFile, IsThatOfTheFunctionForWhichItIsWorst)
{
    PictureResult picture = right_picture();
    picture.isolated.push_back(picture.isolated[0]);
    picture.isolated[1].rendering->picture->rgb[0] = 0.9f;
    picture.isolated[1].score = 0.5;
    EXPECT_EQ(picture_file(picture, PictureKind::isolated), "pictures/clamped.isolated.png");
}

TEST(DrawDifference, IsBlackWhereEqualAndWhiteWhereNotFinite)
{
    Picture const expected = grey_picture(3, 1, 0.5f);
    Picture submitted = expected;
    submitted.rgb[3] = NAN;
    submitted.rgb[6] = HUGE_VALF;
    Picture const difference = draw_difference(submitted, expected);
    EXPECT_EQ(difference.width, 3);
    EXPECT_EQ(brightness(difference, 0), 0);
    EXPECT_EQ(brightness(difference, 1), 3);
    EXPECT_EQ(brightness(difference, 2), 3);
}

TEST(DrawDifference, IsBrighterForLargerDifferences)
{
    Picture const expected = grey_picture(6, 1, 0.f);
    Picture submitted = expected;
    float const values[] = {0, 0.001f, 0.01f, 0.1f, 0.5f, 1};
    for (std::size_t i = 0; i < 6; ++i)
        submitted.rgb[3 * i + 1] = values[i];
    Picture const difference = draw_difference(submitted, expected);
    for (std::size_t i = 1; i < 6; ++i)
        EXPECT_GT(brightness(difference, i), brightness(difference, i - 1)) << i;
}

TEST(WritePictures, WritesTheFilesThatReportsName)
{
    TemporaryDirectory const directory;
    write_file(directory.path() / "clamped.png", "the expected one");
    CheckResults results;
    results.pictures = {wrong_picture()};
    write_pictures(results, directory.path(), directory.path());
    EXPECT_EQ(files_in(directory.path() / "pictures"),
              (std::set<std::string>{"clamped.expected.png", "clamped.submitted.png", "clamped.difference.png"}));
}

TEST(WritePictures, ReplacesTheOldOnes)
{
    TemporaryDirectory const directory;
    write_file(directory.path() / "clamped.png", "the expected one");
    std::filesystem::create_directories(directory.path() / "pictures");
    write_file(directory.path() / "pictures" / "old.png", "");
    CheckResults results;
    results.pictures = {right_picture()};
    write_pictures(results, directory.path(), directory.path());
    EXPECT_EQ(files_in(directory.path() / "pictures"), std::set<std::string>{"clamped.expected.png"});
    EXPECT_EQ(files_in(directory.path()), (std::set<std::string>{"clamped.png", "pictures"}));
}
}  // namespace testat
