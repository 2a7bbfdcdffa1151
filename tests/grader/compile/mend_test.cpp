#include "compile/mend.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
constexpr char file[] =
    "#include <x>\n"
    "int ImageTexture::wrap_clamp(int v, int n)\n"
    "{\n"
    "    return v CLAMP;\n"
    "}\n"
    "int ImageTexture::wrap_repeat(int v, int n)\n"
    "{\n"
    "    return v REPEAT;\n"
    "}\n"
    "int helper() { return HELPER; }\n";

Finished succeed()
{
    Finished finished;
    finished.exit_code = 0;
    return finished;
}

Finished fail(std::string const& output)
{
    Finished finished;
    finished.exit_code = 1;
    finished.output = output;
    return finished;
}

/// Takes certain words for errors, in this order.
class CompilerOfWords {
public:
    explicit CompilerOfWords(std::vector<std::string> words) : words_(std::move(words)) {}

    Finished operator()(std::string const& text)
    {
        ++calls;
        std::string output;
        for (auto const& word : words_)
            if (auto const at = text.find(word); at != std::string::npos)
                output += "exercise_03.cpp:" +
                          std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n')) +
                          ":1: error: " + word + "\n";
        return output.empty() ? succeed() : fail(output);
    }

    int calls = 0;

private:
    std::vector<std::string> words_;
};

std::optional<Mended> mend_file(std::string const& text, CompilerOfWords& compiler)
{
    Finished const failed = compiler(text);
    compiler.calls = 0;
    return mend(text, failed, {"exercise_03.cpp", "Mein Code.cpp", "usual.h"}, std::ref(compiler));
}

/// "wrap_clamp 4: message; ..."
std::string broken_in(std::optional<Mended> const& mended)
{
    if (!mended)
        return "nothing mended";
    std::string all;
    for (auto const& [function, error] : mended->broken)
        all += (all.empty() ? "" : "; ") + std::string(info(function).name) + " " + std::to_string(error.line) + ": " +
               error.message;
    return all;
}

std::string broken_by(std::vector<std::string> const& words)
{
    CompilerOfWords compiler(words);
    return broken_in(mend_file(file, compiler));
}
}  // namespace

TEST(Mend, LeavesOutTheFunctionWithTheError)
{
    CompilerOfWords compiler({"REPEAT"});
    auto const mended = mend_file(file, compiler);
    EXPECT_EQ(broken_in(mended), "wrap_repeat 8: REPEAT");
    EXPECT_EQ(compiler.calls, 1);
    EXPECT_EQ(mended->text.find("wrap_repeat"), std::string::npos);
    EXPECT_EQ(mended->text.find("helper"), std::string(file).find("helper"));
    EXPECT_EQ(std::count(mended->text.begin(), mended->text.end(), '\n'), 10);
}

TEST(Mend, TakesSeveralRounds)
{
    EXPECT_EQ(broken_by({"REPEAT", "CLAMP"}), "wrap_clamp 4: CLAMP; wrap_repeat 8: REPEAT");
}

/// What follows from it may lie anywhere.
TEST(Mend, BelievesOnlyTheFirstError)
{
    EXPECT_EQ(broken_by({"CLAMP", "v CLAMP"}), "wrap_clamp 4: CLAMP");
    CompilerOfWords compiler({});
    auto const mended = mend(file, fail("exercise_03.cpp:4:1: error: a\nexercise_03.cpp:8:1: error: b\n"),
                             {"exercise_03.cpp", "", ""}, std::ref(compiler));
    EXPECT_EQ(broken_in(mended), "wrap_clamp 4: a");
}

TEST(Mend, LeavesOutOtherDeclarations)
{
    CompilerOfWords compiler({"HELPER"});
    auto const mended = mend_file(file, compiler);
    ASSERT_TRUE(mended);
    EXPECT_TRUE(mended->broken.empty());
    ASSERT_EQ(mended->left_out.size(), 1u);
    EXPECT_EQ(mended->left_out[0].line, 10);
    EXPECT_EQ(mended->left_out[0].message, "HELPER");
    EXPECT_EQ(mended->text.find("helper"), std::string::npos);
    EXPECT_NE(mended->text.find("wrap_repeat"), std::string::npos);
    EXPECT_EQ(broken_by({"CLAMP", "HELPER"}), "wrap_clamp 4: CLAMP");
}

/// Another takes the place. What needs more is to blame next.
TEST(Mend, LeavesOutIncludes)
{
    CompilerOfWords compiler({"<x>"});
    auto const mended = mend_file(file, compiler);
    ASSERT_TRUE(mended);
    EXPECT_TRUE(mended->broken.empty());
    ASSERT_EQ(mended->left_out.size(), 1u);
    EXPECT_EQ(mended->left_out[0].line, 1);
    EXPECT_EQ(mended->text.substr(0, mended->text.find('\n')), "#include \"usual.h\" " + std::string(12, ' '));
    EXPECT_EQ(mended->text.substr(mended->text.find('\n')), std::string(file).substr(std::string(file).find('\n')));
    EXPECT_EQ(broken_by({"<x>", "CLAMP"}), "wrap_clamp 4: CLAMP");
}

TEST(Mend, GivesUpOnErrorsOutsideAllDeclarations)
{
    CompilerOfWords compiler({"#pragma"});
    EXPECT_EQ(broken_in(mend_file(std::string("#pragma x\n") + file, compiler)), "nothing mended");
    CompilerOfWords another({"CLAMP", "#pragma"});
    EXPECT_EQ(broken_in(mend_file(std::string("#pragma x\n") + file, another)), "nothing mended");
}

TEST(Mend, GivesUpWithoutTime)
{
    Finished late = fail("exercise_03.cpp:4:1: error: a\n");
    late.timed_out = true;
    CompilerOfWords compiler({});
    EXPECT_EQ(broken_in(mend(file, late, {"exercise_03.cpp", "", ""}, std::ref(compiler))), "nothing mended");
    EXPECT_EQ(broken_in(mend(file, fail("exercise_03.cpp:4:1: error: a\n"), {"exercise_03.cpp", "", ""},
                             [&](std::string const&) { return late; })),
              "nothing mended");
}

TEST(Mend, BlamesNoFunctionTwice)
{
    int calls = 0;
    auto const stubborn = [&](std::string const&) {
        ++calls;
        return fail("exercise_03.cpp:4:1: error: a\n");
    };
    EXPECT_EQ(broken_in(mend(file, stubborn(""), {"exercise_03.cpp", "", ""}, stubborn)), "nothing mended");
    EXPECT_EQ(calls, 2);
}

TEST(Mend, BlamesTheFunctionThatRefersToWhatIsUndefined)
{
    CompilerOfWords compiler({});
    auto const mended = mend(file,
                             fail("mold: error: undefined symbol: nowhere(int)\n>>> referenced by exercise_03.cpp\n"
                                  ">>>    /tmp/cc.o:(ImageTexture::wrap_repeat(int, int))\n"),
                             {"exercise_03.cpp", "", ""}, std::ref(compiler));
    EXPECT_EQ(broken_in(mended), "wrap_repeat 6: undefined symbol: nowhere(int)");
}

TEST(Mend, BlamesTheFunctionThatIsNotClosed)
{
    std::string text = file;
    text.erase(text.find("}\n"), 1);
    CompilerOfWords compiler({});
    auto const mended = mend(text, fail("exercise_03.cpp:7:1: error: not allowed here\n"), {"exercise_03.cpp", "", ""},
                             std::ref(compiler));
    EXPECT_EQ(broken_in(mended), "wrap_clamp 2: a '}' is missing before line 6: not allowed here");
    EXPECT_NE(mended->text.find("wrap_repeat"), std::string::npos);
}

TEST(Mend, FindsErrorsInTemplatesOfOthers)
{
    CompilerOfWords compiler({});
    auto const mended = mend(file, fail("exercise_03.cpp:8:3:   required from here\n/usr/stl.h:1:1: error: no match\n"),
                             {"exercise_03.cpp", "", ""}, std::ref(compiler));
    EXPECT_EQ(broken_in(mended), "wrap_repeat 8: no match");
}

/// They would name a line of another function, or of another file.
TEST(Mend, CompilesAgainWithoutLineDirectives)
{
    CompilerOfWords compiler({"REPEAT"});
    auto const mended = mend(std::string("#line 100\n") + file, fail("exercise_03.cpp:4:1: error: elsewhere\n"),
                             {"exercise_03.cpp", "", ""}, std::ref(compiler));
    EXPECT_EQ(broken_in(mended), "wrap_repeat 9: REPEAT");
    EXPECT_EQ(compiler.calls, 2);
}

TEST(Mend, GivesUpIfOnlyALineDirectiveIsWrong)
{
    CompilerOfWords compiler({});
    EXPECT_EQ(broken_in(mend(std::string("#line 0\n") + file, fail("exercise_03.cpp:1:1: error: 0\n"),
                             {"exercise_03.cpp", "", ""}, std::ref(compiler))),
              "nothing mended");
}

TEST(WithoutLineDirectives, BlanksThem)
{
    for (std::string const directive : {"#line 5", "  #  line 5 \"a.cpp\"", "# 5 \"a.cpp\" 2", "%:line 5"})
        EXPECT_EQ(without_line_directives("a\n" + directive + "\nb"),
                  "a\n" + std::string(directive.size(), ' ') + "\nb");
    EXPECT_EQ(without_line_directives("#line \\\n5\nb"), "       \n \nb");
    EXPECT_EQ(without_line_directives("#line \\\r\n5"), "        \n ");
}

TEST(WithoutLineDirectives, LeavesEverythingElse)
{
    for (std::string const text :
         {"", "\n", "#include <line>\n# define x\n#", "int line = 5; // #line 5\n\\\n", "%", "#"})
        EXPECT_EQ(without_line_directives(text), text);
}
}  // namespace testat
