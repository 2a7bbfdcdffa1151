#include "batch/similarity.h"

#include "installation.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace testat {
namespace {
std::string text_of(std::filesystem::path const& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

Upload upload_of(std::filesystem::path const& place, std::string const& student, std::string const& text)
{
    Upload upload;
    upload.student = student;
    upload.file = place / (student + ".cpp");
    write_file(upload.file, text);
    return upload;
}

/// Ten lines that are in no template.
std::string own_function(std::string const& name, char const* operation)
{
    std::string text = "int " + name + "(int a, int b)\n{\n";
    for (int i = 0; i < 10; ++i)
        text += "    " + name + "_t" + std::to_string(i) + " = a " + operation + " b * " + std::to_string(i) + ";\n";
    return text + "}\n";
}
}  // namespace

TEST(Similarity, FindsWhatWasRenamed)
{
    TemporaryDirectory const place;
    auto const pairs = find_similar({upload_of(place.path(), "anna", own_function("f", "+")),
                                     upload_of(place.path(), "bert", own_function("another_name", "+")),
                                     upload_of(place.path(), "carl", "struct S { double x, y; };\n")},
                                    {});
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].first, "anna");
    EXPECT_EQ(pairs[0].second, "bert");
    EXPECT_GE(pairs[0].percent, 90);
    EXPECT_NE(pairs[0].passages.find("another_name"), std::string::npos) << pairs[0].passages;
}

TEST(Similarity, DoesNotCountTheTemplate)
{
    TemporaryDirectory const place;
    std::string const given = text_of(installation().exercise_template);
    EXPECT_TRUE(
        find_similar({upload_of(place.path(), "anna", given), upload_of(place.path(), "bert", given)}, {}).empty());
    EXPECT_EQ(without_template(given, given), "");
}

TEST(Similarity, ComparesWithEarlierYearsButNotTheseWithEachOther)
{
    TemporaryDirectory const place;
    std::string const text = own_function("f", "+");
    auto const pairs = find_similar({upload_of(place.path(), "anna", text)},
                                    {upload_of(place.path(), "old1", text), upload_of(place.path(), "old2", text)});
    EXPECT_EQ(pairs.size(), 2u);
    EXPECT_NE(similarity_to_text(pairs, Language::en).find("(earlier) old1"), std::string::npos);
}

TEST(Similarity, SurvivesAnyBytes)
{
    TemporaryDirectory const place;
    std::string bytes;
    for (int i = 0; i < 4096; ++i)
        bytes += static_cast<char>(i * 7 % 256);
    EXPECT_NO_THROW(find_similar({upload_of(place.path(), "anna", bytes), upload_of(place.path(), "bert", bytes)}, {}));
}
}  // namespace testat
