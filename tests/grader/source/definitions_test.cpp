#include "source/definitions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

namespace testat {
namespace {
std::string read(std::string const& file)
{
    std::ifstream in(std::string(TESTAT_REPOSITORY) + "/" + file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

FunctionSet functions_of(std::string_view text)
{
    FunctionSet found;
    for (auto const& d : find_definitions(text))
        found = found.with(d.function);
    return found;
}

std::string text_of(std::string_view text, Definition const& d)
{
    return std::string(text.substr(d.begin, d.end - d.begin));
}

/// The one definition in the text, as it stands there.
std::string only_definition(std::string_view text)
{
    auto const found = find_definitions(text);
    return found.size() == 1 ? text_of(text, found[0]) : std::to_string(found.size()) + " definitions";
}

constexpr char clamp[] = "int ImageTexture::wrap_clamp(int v, int n) { return v < n ? v : n - 1; }";

void expect_recovered_in_order(std::string_view text)
{
    std::size_t last = 0;
    for (auto const& d : recover_definitions(text)) {
        ASSERT_LE(last, d.begin);
        ASSERT_LT(d.begin, d.body);
        ASSERT_LT(d.body, d.end);
        ASSERT_LE(d.end, text.size());
        last = d.end;
    }
}

/// Offsets lie in the text and in order.
void expect_sane(std::string_view text)
{
    expect_recovered_in_order(text);
    std::size_t last = 0;
    for (auto const& d : find_definitions(text)) {
        ASSERT_LE(last, d.begin);
        ASSERT_LT(d.begin, d.body);
        ASSERT_LT(d.body, d.end);
        ASSERT_LE(d.end, text.size());
        ASSERT_EQ(text[d.body], '{');
        last = d.end;
    }
}
}  // namespace

TEST(FindDefinitions, FindsElevenInTheReference)
{
    std::string const text = read("references/exercise_03.cpp");
    EXPECT_EQ(find_definitions(text).size(), function_count);
    EXPECT_EQ(functions_of(text), FunctionSet::all());
}

TEST(FindDefinitions, FindsElevenInTheTemplate)
{
    std::string const text = read("submission_template/exercise_03.cpp");
    EXPECT_EQ(find_definitions(text).size(), function_count);
    EXPECT_EQ(functions_of(text), FunctionSet::all());
}

TEST(FindDefinitions, GivesTheWholeDefinition)
{
    std::string const text = std::string("int a;\n\n  ") + clamp + "\nint b;";
    auto const found = find_definitions(text);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(text_of(text, found[0]), clamp);
    EXPECT_EQ(text.substr(found[0].body, 8), "{ return");
    EXPECT_EQ(found[0].line, 3);
}

TEST(FindDefinitions, SkipsDeclarations)
{
    EXPECT_TRUE(
        find_definitions(
            "struct ImageTexture; int ImageTexture::wrap_clamp(int, int); int ImageTexture::wrap_repeat(int, int);")
            .empty());
    EXPECT_EQ(only_definition(std::string("int ImageTexture::wrap_clamp(int, int);\n") + clamp), clamp);
}

TEST(FindDefinitions, SkipsCallsInOtherFunctions)
{
    EXPECT_TRUE(find_definitions("int helper() { return transform_position(1, 2); }").empty());
    EXPECT_EQ(only_definition(std::string("int h() { if (transform_position(1, 2)) { } return 0; }\n") + clamp), clamp);
}

TEST(FindDefinitions, SkipsClassMembers)
{
    EXPECT_TRUE(find_definitions("struct Mine { int transform_position(int a) { return a; } };").empty());
}

TEST(FindDefinitions, AllowsConstNoexceptAndOverride)
{
    EXPECT_EQ(find_definitions("V ImageTexture::evaluate_nearest(int l, U const& uv) const { return V(); }").size(),
              1u);
    EXPECT_EQ(find_definitions("int ImageTexture::wrap_clamp(int a, int b) noexcept { return a; }").size(), 1u);
    EXPECT_EQ(find_definitions("bool Object::intersect(R const& r, I* i) const noexcept override { return 0; }").size(),
              1u);
}

TEST(FindDefinitions, AllowsSpaceAnywhere)
{
    EXPECT_EQ(only_definition("int ImageTexture\n :: \n wrap_clamp\t(int a,\n int b)\n\n{ return a; }"),
              "int ImageTexture\n :: \n wrap_clamp\t(int a,\n int b)\n\n{ return a; }");
}

TEST(FindDefinitions, SkipsComments)
{
    EXPECT_TRUE(find_definitions("// int ImageTexture::wrap_clamp(int a, int b) { return a; }").empty());
    EXPECT_TRUE(find_definitions("/* int ImageTexture::wrap_clamp(int a, int b) { return a; } */").empty());
    EXPECT_TRUE(find_definitions("// continued \\\nint ImageTexture::wrap_clamp(int a, int b) { return a; }").empty());
    EXPECT_EQ(
        find_definitions("int f() { /* } */ return 0; // } \n } int ImageTexture::wrap_clamp(int a, int) { return a; }")
            .size(),
        1u);
}

TEST(FindDefinitions, SkipsBracesInLiterals)
{
    for (char const* literal : {R"("}{\"}")", "'}'", "'\\''", "L'}'", "u8\"}\"", "\"\\\\\"", "R\"(})\"",
                                "R\"x()\"})x\"", "u8R\"(\n}\")\"", "1'000'000", "0x1'fp3", "1.5e+3"}) {
        std::string const text =
            std::string("int ImageTexture::wrap_clamp(int v, int n) { f(") + literal + "); return v; }";
        EXPECT_EQ(only_definition(text + " int x;"), text) << literal;
    }
}

TEST(FindDefinitions, SkipsPreprocessorLines)
{
    EXPECT_EQ(only_definition(std::string("#define OPEN {\n#include \"x\"\n") + clamp), clamp);
    EXPECT_EQ(only_definition(std::string("#define OPEN \\\n  { \\\r\n { {\n") + clamp), clamp);
    EXPECT_EQ(only_definition(std::string("  #  pragma { (\n") + clamp), clamp);
}

TEST(FindDefinitions, KnowsRawStringsFromMacros)
{
    EXPECT_EQ(only_definition(std::string("auto s = FOUR\"x\";\n") + clamp), clamp);
}

/// Uploads are searched in the judge itself, where nothing limits the time.
TEST(FindDefinitions, TakesTimeInProportion)
{
    std::string nested, many;
    while (nested.size() < 1'000'000) {
        nested += "transform_position(";
        many += "transform_position(){}\n";
    }
    EXPECT_TRUE(find_definitions(nested).empty());
    EXPECT_EQ(find_definitions(many).size(), many.size() / 23);
    EXPECT_EQ(find_definitions(many).back().line, int(many.size() / 23));
}

TEST(FindDefinitions, SkipsWhatIsLeftOut)
{
    std::string const dead = "int ImageTexture::wrap_repeat(int a, int) { don't { }\n";
    EXPECT_EQ(only_definition("#if 0\n" + dead + "#endif\n" + clamp), clamp);
    EXPECT_EQ(only_definition("#if 0\n#if 1\n" + dead + "#else\n" + dead + "#endif\n" + dead + "# else\n" + clamp +
                              "\n#endif\n"),
              clamp);
    EXPECT_EQ(only_definition("#if 0\n" + dead), "0 definitions");
}

TEST(FindDefinitions, WantsMembersBehindTheirClass)
{
    EXPECT_TRUE(find_definitions("int wrap_clamp(int a, int b) { return a; }").empty());
    EXPECT_TRUE(find_definitions("int Object::wrap_clamp(int a, int b) { return a; }").empty());
    EXPECT_TRUE(find_definitions("V Object::transform_position(M const& m, V const& p) { return p; }").empty());
    EXPECT_EQ(find_definitions("V transform_position(M const& m, V const& p) { return p; }").size(), 1u);
}

TEST(FindDefinitions, ReadsCrlf)
{
    EXPECT_EQ(find_definitions("#include <x>\r\nint ImageTexture::wrap_clamp(int a, int b)\r\n{\r\n return a;\r\n}\r\n")
                  .size(),
              1u);
}

TEST(FindDefinitions, NeverFailsOnCutText)
{
    std::string const text = read("references/exercise_03.cpp");
    for (std::size_t length = 0; length < text.size(); length += 7)
        expect_sane(std::string_view(text).substr(0, length));
}

TEST(FindDefinitions, NeverFailsOnRandomBytes)
{
    for (unsigned seed = 0; seed < 10'000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 engine(seed);
        std::string bytes(engine() % 200, '\0');
        std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(engine()); });
        expect_sane(bytes);
    }
}

TEST(FindDefinitions, NeverFailsOnRandomTokens)
{
    constexpr char const* tokens[] = {"transform_position",
                                      "ImageTexture::wrap_clamp",
                                      "#if 0\n",
                                      "#endif\n",
                                      "(",
                                      ")",
                                      "{",
                                      "}",
                                      ";",
                                      "::",
                                      "\"",
                                      "'",
                                      "R\"",
                                      "R\"(",
                                      ")\"",
                                      "\\",
                                      "\n",
                                      "#",
                                      "//",
                                      "/*",
                                      "*/",
                                      "\\\n",
                                      "1'",
                                      "const",
                                      "int",
                                      "'{'",
                                      "\r",
                                      "intersect",
                                      " "};
    for (unsigned seed = 0; seed < 10'000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 engine(seed);
        std::string text;
        for (unsigned i = engine() % 60; i > 0; --i)
            text += tokens[engine() % std::size(tokens)];
        expect_sane(text);
    }
}

namespace {
constexpr char repeat[] = "int ImageTexture::wrap_repeat(int v, int n) { return v % n; }";

/// What is recovered, as it stands in the text, with a mark behind what the next definition cuts.
std::vector<std::string> recovered(std::string_view text)
{
    std::vector<std::string> found;
    for (auto const& d : recover_definitions(text))
        found.push_back(text_of(text, d) + (d.closed ? "" : " CUT"));
    return found;
}

using Texts = std::vector<std::string>;
}  // namespace

TEST(RecoverDefinitions, FindsTheSameInWhatCompiles)
{
    for (char const* file : {"references/exercise_03.cpp", "submission_template/exercise_03.cpp"}) {
        std::string const text = read(file);
        auto const expected = find_definitions(text);
        auto const found = recover_definitions(text);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(text_of(text, found[i]), text_of(text, expected[i]));
            EXPECT_EQ(found[i].line, expected[i].line);
            EXPECT_TRUE(found[i].closed);
        }
    }
}

TEST(RecoverDefinitions, EndsAFunctionWithoutClosingBraceAtTheNext)
{
    std::string const torn = "int ImageTexture::wrap_clamp(int v, int n) { return v;";
    EXPECT_EQ(recovered(torn + "\n// about the next\n" + repeat), (Texts{torn + " CUT", repeat}));
    std::string const inner = "int ImageTexture::wrap_clamp(int v, int n) { if (v) { return v; }";
    EXPECT_EQ(recovered(inner + "\n" + repeat), (Texts{inner + " CUT", repeat}));
    EXPECT_EQ(recovered(torn + "\n" + repeat + " }"), (Texts{torn + " CUT", repeat}));
}

TEST(RecoverDefinitions, EndsTheLastWithoutClosingBraceWithTheText)
{
    std::string const torn = "int ImageTexture::wrap_clamp(int v, int n) { return v;\n\n";
    EXPECT_EQ(recovered(torn), Texts{torn});
}

TEST(RecoverDefinitions, TakesASurplusBraceToTheFunctionBefore)
{
    std::string const surplus = "int ImageTexture::wrap_clamp(int v, int n) { if (v) } v = 1; for (;;) { } return v; }";
    EXPECT_EQ(recovered(surplus + "\n" + repeat), (Texts{surplus, repeat}));
    EXPECT_EQ(recovered(std::string("}\n") + repeat), Texts{repeat});
}

TEST(RecoverDefinitions, FindsFunctionsWithoutOpeningBrace)
{
    std::string const torn = "int ImageTexture::wrap_clamp(int v, int n) if (v) { v = 1; } return v; }";
    EXPECT_EQ(recovered(torn + "\n" + repeat), (Texts{torn, repeat}));
}

TEST(RecoverDefinitions, FindsFunctionsWithoutClosingParenthesis)
{
    std::string const torn = "int ImageTexture::wrap_clamp(int v, int n { return f(v); }";
    EXPECT_EQ(recovered(torn + "\n" + repeat), (Texts{torn, repeat}));
}

TEST(RecoverDefinitions, FindsFunctionsWithASemicolonBeforeTheBody)
{
    std::string const torn = "int ImageTexture::wrap_clamp(int v, int n); { return v; }";
    EXPECT_EQ(recovered(torn + "\n" + repeat), (Texts{torn, repeat}));
    std::string const member = "V ImageTexture::evaluate_nearest(int level, V const& uv) const; { return uv; }";
    EXPECT_EQ(recovered(member + "\n" + repeat), (Texts{member, repeat}));
}

TEST(RecoverDefinitions, SkipsDeclarationsAndCalls)
{
    EXPECT_TRUE(recovered("V transform_position(M const& m, V const& p);").empty());
    EXPECT_TRUE(recovered("int h() { return transform_position(1, 2); }").empty());
    EXPECT_TRUE(recovered("V const origin = transform_position(m, p);").empty());
}

/// Only what is qualified cannot stand in a function.
TEST(RecoverDefinitions, LeavesClassesInFunctions)
{
    std::string const text =
        "int ImageTexture::wrap_clamp(int v, int n) { struct S { int transform_position(int p) { return p; } }; "
        "return v; }";
    EXPECT_EQ(recovered(text + repeat), (Texts{text, repeat}));
}

TEST(RecoverDefinitions, TakesTimeInProportion)
{
    for (std::string const part :
         {"transform_position(", "transform_position(){", "transform_position(){}", "ImageTexture::wrap_clamp(){",
          "transform_position() ", "}", "transform_position(;"}) {
        std::string text = "transform_position(){";
        while (text.size() < 1'000'000)
            text += part;
        EXPECT_LE(recover_definitions(text).size(), text.size() / 15) << part;
    }
}

TEST(FindDeclaration, FindsWhatALineIsPartOf)
{
    std::string const text =
        "#include <x>\n"
        "struct S { int a;\n"
        "  int b; };\n"
        "int f(int i)\n"
        "{ for (;;) { }\n"
        "}\n"
        "namespace { namespace a::b {\n"
        "int g() { return 1; }  int h();\n"
        "} }\n"
        "x y\n"
        ";\n";
    auto const found = [&](int line) {
        Extent const e = find_declaration(text, line);
        return text.substr(e.begin, e.end - e.begin);
    };
    EXPECT_EQ(found(1), "");
    EXPECT_EQ(found(2), "struct S { int a;\n  int b; };");
    EXPECT_EQ(found(3), found(2));
    EXPECT_EQ(found(4), "int f(int i)\n{ for (;;) { }\n}");
    EXPECT_EQ(found(6), found(4));
    EXPECT_EQ(found(8), "int g() { return 1; }");
    EXPECT_EQ(found(10), "x y\n;");
    EXPECT_EQ(found(12), "");
}

TEST(FindDeclaration, NeverFailsOnWhatIsNoCpp)
{
    for (std::string const text : {"", "}", "{", "(", "namespace", "namespace {", "namespace a", "x", "a { ( } ) ;",
                                   "}}{{", "f(", "f()", "f() {", "f(;"})
        for (int line = 0; line < 3; ++line)
            EXPECT_LE(find_declaration(text, line).end, text.size()) << text;
}

TEST(ReplaceBody, ReplacesThatBodyOnly)
{
    std::string const other = " int ImageTexture::wrap_repeat(int a, int) { return a; }";
    EXPECT_EQ(replace_body(std::string("int ImageTexture::wrap_clamp(int a, int) { return a; }") + other,
                           Function::wrap_clamp, "{ abort(); }"),
              "int ImageTexture::wrap_clamp(int a, int) { abort(); }" + other);
}

TEST(ReplaceBody, LeavesTextWithoutTheFunction)
{
    EXPECT_EQ(replace_body(clamp, Function::wrap_repeat, "{}"), clamp);
}

TEST(ReplaceBody, LeavesTheOtherTenAlone)
{
    std::string const text = read("references/exercise_03.cpp");
    for (Function f : every_function()) {
        std::string const blank = replace_body(text, f, "{}");
        EXPECT_EQ(functions_of(blank), FunctionSet::all()) << info(f).name;
        EXPECT_LT(blank.size(), text.size()) << info(f).name;
    }
}

TEST(PatchDefinitions, TakesThePatchsFunctions)
{
    std::string const base = "#include <a>\nint ImageTexture::wrap_clamp(int a, int) { return 1; }\n";
    EXPECT_EQ(patch_definitions(base, "int ImageTexture::wrap_clamp(int b, int) { return 2; }"),
              "#include <a>\n\nint ImageTexture::wrap_clamp(int b, int) { return 2; }\n");
}

TEST(PatchDefinitions, PutsHelpersBeforeTheFirstFunction)
{
    std::string const text = patch_definitions(read("references/exercise_03.cpp"),
                                               "static int help() { return 1; }\n"
                                               "int ImageTexture::wrap_repeat(int, int) { return help(); }\n");
    EXPECT_EQ(functions_of(text), FunctionSet::all());
    EXPECT_LT(text.find("static int help()"), find_definitions(text)[0].begin);
    EXPECT_NE(text.find("{ return help(); }"), std::string::npos);
}

TEST(PatchDefinitions, KeepsTheBaseWithAnEmptyPatch)
{
    std::string const base = read("references/exercise_03.cpp");
    EXPECT_EQ(find_definitions(patch_definitions(base, "")).size(), function_count);
}
}  // namespace testat
