#include "batch/names.h"

#include <gtest/gtest.h>

namespace testat {
TEST(UserFolderName, HasItsIdBehindTheLastUnderscore)
{
    auto const folder = parse_user_folder("Mueller_Anna_uabcd_12345");
    ASSERT_TRUE(folder);
    EXPECT_EQ(folder->person, "Mueller_Anna_uabcd");
    EXPECT_EQ(folder->usr_id, "12345");
    EXPECT_EQ(parse_user_folder("van_der_Berg_Jan_j_b_7")->usr_id, "7");
    EXPECT_EQ(parse_user_folder("______uabcd_12")->usr_id, "12");
}

TEST(UserFolderName, IsNoOtherName)
{
    for (char const* name : {"", "_", "Submissions", "Team 17", "a_1", "Sheet_3", "Mueller_Anna_uabcd", "a_b_c_",
                             "a_b_c_12x", "a_b_c_1234567890123456789"})
        EXPECT_FALSE(parse_user_folder(name)) << name;
}

TEST(TeamFolder, HasANumber)
{
    EXPECT_EQ(parse_team("Team 17"), "17");
    EXPECT_FALSE(parse_team("Team"));
    EXPECT_FALSE(parse_team("Sheet 17"));
}

TEST(FileNames, AreLateWithAText)
{
    for (char const* name : {"Late - exercise_03.cpp", "Verspätete Abgabe - exercise_03 (2).cpp", "a - b - 03.cpp"}) {
        EXPECT_TRUE(parse_file_name(name).is_late) << name;
        EXPECT_TRUE(parse_file_name(name).is_expected) << name;
    }
    for (char const* name : {"exercise_03.cpp", "exercise_03 - final.cpp", " - exercise_03.cpp", "a-b.cpp"})
        EXPECT_FALSE(parse_file_name(name).is_late) << name;
}

TEST(FileNames, AreNumberedWhenRepeated)
{
    EXPECT_EQ(parse_file_name("exercise_03.cpp").number, 1);
    EXPECT_EQ(parse_file_name("exercise_03 (2).cpp").number, 2);
    EXPECT_EQ(parse_file_name("exercise_03(12).CPP").number, 12);
    EXPECT_EQ(parse_file_name("exercise_03 ().cpp").number, 1);
    EXPECT_EQ(parse_file_name("exercise_03 (99999999999).cpp").number, 1);
}

TEST(FileNames, AreExpectedAlsoWhenCut)
{
    EXPECT_TRUE(parse_file_name("03.cpp").is_expected);
    EXPECT_FALSE(parse_file_name("main.cpp").is_expected);
    EXPECT_TRUE(parse_file_name("main.cpp").is_source);
    EXPECT_FALSE(parse_file_name("exercise_03.cpp.txt").is_source);
    EXPECT_FALSE(parse_file_name("cpp").is_source);
}

TEST(MayBe, KnowsWaysOfReplacingLetters)
{
    for (char const* person : {"Mueller_Joerg_uab", "Muller_Jorg_uab", "M_ller_J_rg_uab", "M__ller_J__rg_uab",
                               "Müller_Jörg_uab", "Mller_Jrg_UAB"})
        EXPECT_TRUE(may_be(person, "Müller", "Jörg", "uab")) << person;
    EXPECT_TRUE(may_be("O_Neil_Anne-Marie_x", "O'Neil", "Anne-Marie", "x"));
    EXPECT_TRUE(may_be("ONeil_Anne Marie_x", "O'Neil", "Anne-Marie", "x"));
    EXPECT_TRUE(may_be("____zhuang_uab", "王", "爽", "uab"));
    EXPECT_TRUE(may_be("Wang_Shuang_uab", "王", "爽", "uab"));
    EXPECT_TRUE(may_be("_________uab", "محمد", "", "uab"));
}

TEST(MayBe, KeepsApartWhoDiffers)
{
    EXPECT_FALSE(may_be("Mueller_Jana_uab", "Müller", "Jörg", "uab"));
    EXPECT_FALSE(may_be("Mueller_Joerg_uac", "Müller", "Jörg", "uab"));
    EXPECT_FALSE(may_be("Wang_Shuang_uab", "王", "爽", "uac"));
    EXPECT_FALSE(may_be("", "a", "b", "c"));
}

TEST(SafeFileName, IsOneFileAnywhere)
{
    EXPECT_EQ(safe_file_name("Mueller_Anna_uabcd_12345"), "Mueller_Anna_uabcd_12345");
    EXPECT_EQ(safe_file_name("王.cpp"), "王.cpp");
    EXPECT_EQ(safe_file_name("a/b\\c:d.cpp"), "a_b_c_d.cpp");
    EXPECT_EQ(safe_file_name(".."), "_");
    EXPECT_EQ(safe_file_name(""), "_");
    EXPECT_EQ(safe_file_name(".hidden"), "_.hidden");
    EXPECT_EQ(safe_file_name("-rf"), "_-rf");
}

TEST(SafeFileName, IsCutBetweenLetters)
{
    std::string name;
    for (int i = 0; i < 100; ++i)
        name += "王";
    std::string const safe = safe_file_name(name + ".cpp");
    EXPECT_LE(safe.size(), 150u);
    EXPECT_EQ(safe.substr(safe.size() - 7), "王.cpp");
}

TEST(UniqueNames, DifferAlsoWhereCaseDoesNotCount)
{
    UniqueNames names;
    EXPECT_EQ(names.add("Anna"), "Anna");
    EXPECT_EQ(names.add("anna"), "anna (2)");
    EXPECT_EQ(names.add("Anna"), "Anna (3)");
}
}  // namespace testat
