#include "text.h"

#include <gtest/gtest.h>

#include <random>

namespace testat {
namespace {
std::string random_bytes(std::mt19937& engine)
{
    std::string bytes(engine() % 64, '\0');
    for (char& c : bytes)
        c = static_cast<char>(engine());
    return bytes;
}

bool is_control(unsigned char c)
{
    return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
}
}  // namespace

TEST(CleanText, KeepsValidUtf8)
{
    std::string const text = "Übung 3: \xe2\x82\xac 5, \xf0\x9f\x98\x80\n\tok";
    EXPECT_EQ(clean_text(text, 100), text);
}

TEST(CleanText, ReplacesInvalidBytesOneByOne)
{
    std::string const mark = "\xef\xbf\xbd";
    EXPECT_EQ(clean_text("a\xff\xfez", 100), "a" + mark + mark + "z");
    EXPECT_EQ(clean_text("\xc3", 100), mark) << "cut in the middle";
    EXPECT_EQ(clean_text("\xc0\xaf", 100), mark + mark) << "overlong";
    EXPECT_EQ(clean_text("\xe0\x80\xaf", 100), mark + mark + mark) << "overlong";
    EXPECT_EQ(clean_text("\xed\xa0\x80", 100), mark + mark + mark) << "surrogate";
    EXPECT_EQ(clean_text("\xf4\x90\x80\x80", 100), mark + mark + mark + mark) << "behind the last code point";
}

TEST(CleanText, DropsWhatSteersATerminal)
{
    EXPECT_EQ(clean_text("a\x1b[31mred\x1b[0m", 100).find('\x1b'), std::string::npos);
    EXPECT_EQ(clean_text("a\r\nb\a\b\x7f", 100), "a\nb");
    EXPECT_EQ(clean_text("\xc2\x9b"
                         "31m",
                         100),
              "31m")
        << "CSI as a C1 control";
}

TEST(CleanText, DropsBidirectionalOverrides)
{
    EXPECT_EQ(clean_text("a\xe2\x80\xae"
                         "b\xe2\x81\xa6"
                         "c\xe2\x80\x8f",
                         100),
              "abc");
}

TEST(CleanText, KeepsWhatFits)
{
    EXPECT_EQ(clean_text("12345", 5), "12345");
    EXPECT_EQ(clean_text("", 0), "");
}

TEST(CleanText, MarksACut)
{
    EXPECT_EQ(clean_text("123456", 5), "12345...");
    EXPECT_EQ(clean_text("1234\xc3\xbc", 5), "1234...") << "characters are not cut in two";
}

TEST(CleanText, ReadsCharArraysWithoutTerminator)
{
    char const full[3] = {'a', 'b', 'c'};
    char const terminated[4] = {'a', '\0', 'b', 'c'};
    EXPECT_EQ(clean_text(full), "abc");
    EXPECT_EQ(clean_text(terminated), "a");
}

TEST(CleanText, BoundsAndCleansWhatever)
{
    for (unsigned seed = 0; seed < 10'000; ++seed) {
        std::mt19937 engine(seed);
        std::size_t const most = engine() % 40;
        std::string const text = clean_text(random_bytes(engine), most);
        ASSERT_LE(text.size(), most + 3) << "seed " << seed;
        ASSERT_TRUE(std::none_of(text.begin(), text.end(), is_control)) << "seed " << seed;
    }
}

TEST(CleanText, IsCleanAfterOnce)
{
    for (unsigned seed = 0; seed < 10'000; ++seed) {
        std::mt19937 engine(seed);
        std::string const once = clean_text(random_bytes(engine), 1000);
        ASSERT_EQ(clean_text(once, 1000), once) << "seed " << seed;
    }
}

TEST(OneLine, HasNeitherNewlinesNorTabs)
{
    EXPECT_EQ(one_line("a\nb\tc\x1b[31m"), "a b c[31m");
}

TEST(Sha256, MatchesTheStandard)
{
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, ReadsZeroBytesToo)
{
    EXPECT_NE(sha256(std::string(1, '\0')), sha256(std::string(2, '\0')));
}
}  // namespace testat
