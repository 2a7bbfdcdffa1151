#include "compile/diagnostics.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
std::vector<Diagnostic> parse(std::string const& output)
{
    return parse_diagnostics(output, "exercise_03.cpp", "Mein Code.cpp");
}

/// All fields of the only message, or how many there are.
std::string only(std::string const& output)
{
    auto const found = parse(output);
    if (found.size() != 1)
        return std::to_string(found.size()) + " messages";
    auto const& d = found[0];
    return d.file + "|" + std::to_string(d.line) + "|" + std::to_string(d.column) + "|" + d.severity + "|" + d.message;
}

std::string repeat(std::string const& line, int times)
{
    std::string text;
    for (int i = 0; i < times; ++i)
        text += line;
    return text;
}
}  // namespace

TEST(ParseDiagnostics, ReadsGcc)
{
    EXPECT_EQ(only("exercise_03.cpp: In function 'int f()':\n"
                   "exercise_03.cpp:12:5: error: 'x' was not declared in this scope\n"
                   "   12 |     x = 1;\n"
                   "      |     ^\n"),
              "Mein Code.cpp|12|5|error|'x' was not declared in this scope");
}

TEST(ParseDiagnostics, ReadsClang)
{
    EXPECT_EQ(only("exercise_03.cpp:3:10: fatal error: 'nothing.h' file not found\n"
                   "    3 | #include \"nothing.h\"\n"
                   "      |          ^~~~~~~~~~~\n"
                   "1 error generated.\n"),
              "Mein Code.cpp|3|10|fatal error|'nothing.h' file not found");
}

TEST(ParseDiagnostics, ReadsMold)
{
    EXPECT_EQ(only("mold: error: undefined symbol: ImageTexture::wrap_clamp(int, int)\n"
                   ">>> referenced by exercise_03.cpp\n"
                   ">>>               /tmp/ccU3.o:(f())\n"),
              "|0|0|error|undefined symbol: ImageTexture::wrap_clamp(int, int)");
}

TEST(ParseDiagnostics, LeavesOutCollect2)
{
    EXPECT_EQ(only("mold: error: undefined symbol: f()\ncollect2: error: ld returned 1 exit status\n"),
              "|0|0|error|undefined symbol: f()");
}

TEST(ParseDiagnostics, ReadsProgramsWithoutPlace)
{
    EXPECT_EQ(only("cc1plus: fatal error: out of memory\n"), "|0|0|fatal error|out of memory");
    EXPECT_EQ(only("exercise_03.cpp:7: error: no column\n"), "Mein Code.cpp|7|0|error|no column");
}

TEST(ParseDiagnostics, NamesHeadersWithoutTheirPath)
{
    EXPECT_EQ(only("/opt/framework/include/cglib/rt/texture.h:3:1: note: declared here\n"),
              "texture.h|3|1|note|declared here");
}

TEST(ParseDiagnostics, ReadsCrlf)
{
    EXPECT_EQ(only("exercise_03.cpp:1:2: error: broken\r\n"), "Mein Code.cpp|1|2|error|broken");
}

TEST(ParseDiagnostics, ReadsALastLineWithoutItsEnd)
{
    EXPECT_EQ(only("exercise_03.cpp:1:2: error: broken"), "Mein Code.cpp|1|2|error|broken");
}

TEST(ParseDiagnostics, PutsErrorsFirst)
{
    auto const found = parse(
        "exercise_03.cpp:1:1: note: a\nexercise_03.cpp:2:1: warning: b\n"
        "exercise_03.cpp:3:1: error: c\nexercise_03.cpp:4:1: fatal error: d\n");
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0].message + found[1].message + found[2].message + found[3].message, "cdba");
}

TEST(ParseDiagnostics, GivesTwentyAtMost)
{
    auto const found =
        parse(repeat("exercise_03.cpp:1:1: note: n\n", 50) + "exercise_03.cpp:9:9: error: the one that counts\n");
    ASSERT_EQ(found.size(), 20u);
    EXPECT_EQ(found[0].message, "the one that counts");
}

TEST(ParseDiagnostics, CutsLongLines)
{
    auto const found = parse("exercise_03.cpp:1:1: error: " + std::string(1'000'000, 'x') + "\n");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LE(found[0].message.size(), 603u);
}

TEST(ParseDiagnostics, CleansMessagesAndFileNames)
{
    auto const found = parse("a\x1b[2J.h:1:1: error: \x1b[31mred\xff\n");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].message, "[31mred\xef\xbf\xbd");
    EXPECT_EQ(found[0].file, "a[2J.h");
}

TEST(ParseDiagnostics, SkipsWhatIsNoMessage)
{
    EXPECT_TRUE(parse("").empty());
    EXPECT_TRUE(parse("\n\n:\n::\n:1:2: error: no file\nexercise_03.cpp\nerror: no file\n").empty());
    EXPECT_TRUE(parse("exercise_03.cpp:99999999999999999999:1: error: no such line\n").empty());
}

TEST(ParseDiagnostics, HasNoNegativePlaces)
{
    for (auto const& d : parse("a:-5:-6: error: x\n")) {
        EXPECT_GE(d.line, 0);
        EXPECT_GE(d.column, 0);
    }
}

namespace {
/// "message @ lines < referrer" of the first error.
std::string first(std::string const& output)
{
    auto const found = find_first_error(output, "exercise_03.cpp", "Mein Code.cpp");
    if (!found)
        return "none";
    std::string text = found->error.file + ": " + found->error.message + " @";
    for (int const line : found->lines)
        text += " " + std::to_string(line);
    return text + (found->referrer.empty() ? "" : " < " + found->referrer);
}
}  // namespace

TEST(FindFirstError, IsTheFirstInTheOutput)
{
    EXPECT_EQ(first("exercise_03.cpp:9:1: warning: w\n"
                    "exercise_03.cpp:12:5: error: a\n"
                    "exercise_03.cpp:2:5: error: b\n"),
              "Mein Code.cpp: a @ 12");
    EXPECT_EQ(first("exercise_03.cpp:9:1: warning: w\nexercise_03.cpp:9:1: note: n\n"), "none");
    EXPECT_EQ(first(""), "none");
}

TEST(FindFirstError, FollowsTemplatesOfGcc)
{
    EXPECT_EQ(first("exercise_03.cpp:3:1: warning: w\n"
                    "/usr/include/stl_algo.h: In instantiation of 'void f()':\n"
                    "/usr/include/stl_algo.h:4:5:   required from 'void g()'\n"
                    "exercise_03.cpp:27:34:   required from here\n"
                    "/usr/include/predefined_ops.h:45:23: error: no match\n"
                    "exercise_03.cpp:30:1: error: another\n"),
              "predefined_ops.h: no match @ 27");
    EXPECT_EQ(first("exercise_03.cpp:5:34:   required from here\n"
                    "exercise_03.cpp:5:1: warning: w\n"
                    "exercise_03.cpp:8:1: error: e\n"),
              "Mein Code.cpp: e @ 8");
}

TEST(FindFirstError, FollowsTemplatesOfClang)
{
    EXPECT_EQ(first("/usr/include/ops.h:45:23: error: invalid operands\n"
                    "/usr/include/algo.h:16:6: note: in instantiation of function template f requested here\n"
                    "exercise_03.cpp:27:29: note: in instantiation of function template g requested here\n"
                    "exercise_03.cpp:3:1: note: candidate function not viable\n"
                    "exercise_03.cpp:30:1: error: another\n"
                    "exercise_03.cpp:31:1: note: in instantiation of h requested here\n"),
              "ops.h: invalid operands @ 27");
}

TEST(FindFirstError, FollowsMacros)
{
    EXPECT_EQ(first("exercise_03.cpp:3:20: error: no member\n"
                    "exercise_03.cpp:40:5: note: in expansion of macro 'TEXEL'\n"),
              "Mein Code.cpp: no member @ 3 40");
}

TEST(FindFirstError, KnowsWhoMissesASymbol)
{
    EXPECT_EQ(first("mold: error: undefined symbol: nowhere(int)\n"
                    ">>> referenced by exercise_03.cpp\n"
                    ">>>               /tmp/ccU3.o:(ImageTexture::wrap_clamp(int, int))\n"
                    ">>>               /tmp/ccU3.o:(other())\n"
                    "collect2: error: ld returned 1 exit status\n"),
              ": undefined symbol: nowhere(int) @ < ImageTexture::wrap_clamp(int, int)");
}

TEST(FindFirstError, BelongsToNoLineElsewhere)
{
    EXPECT_EQ(first("texture.h:12:5: error: e\n"), "texture.h: e @");
    EXPECT_EQ(first("/other/exercise_03.cpp:12:5: error: e\n"), "exercise_03.cpp: e @");
    EXPECT_EQ(first("cc1plus: fatal error: out of memory\n"), ": out of memory @");
    EXPECT_EQ(first("exercise_03.cpp:-5: error: e\n"), "none");
}
}  // namespace testat
