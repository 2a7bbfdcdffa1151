// Uploads that are no exercise_03.cpp, or do not compile: a report all the same, and 0 points.
#include "end_to_end/testat_program.h"

#include "functions.h"
#include "source/definitions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
Json expect_zero(Graded const& graded)
{
    EXPECT_EQ(graded.exit_code, 0) << graded.out << graded.err;
    EXPECT_EQ(graded.report.at("status"), "graded");
    EXPECT_FALSE(graded.report.at("build").at("ok").get<bool>());
    EXPECT_EQ(graded.report.at("points").at("earned"), 0);
    EXPECT_EQ(graded.report.at("points").at("max"), 20);
    EXPECT_EQ(graded.report.at("policy").at("applied"), Json({"does_not_compile"}));
    EXPECT_FALSE(graded.report.at("build").at("diagnostics").empty());
    return graded.report;
}

std::string first_message(Json const& report)
{
    return report.at("build").at("diagnostics").at(0).at("message");
}

/// The text with the definition of one function taken out.
std::string without(std::string text, Function function)
{
    for (auto const& d : find_definitions(text))
        if (d.function == function)
            return text.erase(d.begin, d.end - d.begin);
    return text;
}

TEST(Upload, MayBeEmpty)
{
    EXPECT_NE(first_message(expect_zero(grade_text(""))).find("empty"), std::string::npos);
    expect_zero(grade_text("\n \t\n"));
}

TEST(Upload, MayBeHuge)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", "int x;\n");
    std::filesystem::resize_file(place.path() / "exercise_03.cpp", 100'000'000);
    Json const report = expect_zero(grade_file(place.path() / "exercise_03.cpp", place.path() / "out"));
    EXPECT_NE(first_message(report).find("1 MB"), std::string::npos);
}

TEST(Upload, MayBeLargerThanTheMemory)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", "int x;\n");
    std::filesystem::resize_file(place.path() / "exercise_03.cpp", std::uintmax_t(1) << 42);
    expect_zero(grade_file(place.path() / "exercise_03.cpp", place.path() / "out"));
}

TEST(Upload, MayBeBinary)
{
    std::string garbage;
    for (unsigned i = 0; i < 4096; ++i)
        garbage += static_cast<char>(i * 2654435761u >> 24);
    EXPECT_NE(first_message(expect_zero(grade_text(garbage))).find("text file"), std::string::npos);
    expect_zero(
        grade_text("\x7f"
                   "ELF\x02\x01\x01"));
    expect_zero(grade_text("PK\x03\x04 an archive instead of the file in it"));
}

TEST(Upload, MayHoldNulBytes)
{
    expect_zero(grade_text(reference_text() + std::string(3, '\0')));
}

TEST(Upload, MayBeUtf16)
{
    std::string wide = "\xff\xfe";
    for (char c : reference_text())
        wide += {c, '\0'};
    expect_zero(grade_text(wide));
}

TEST(Upload, MayHaveAMainOfItsOwn)
{
    Json const report = expect_zero(grade_text(reference_text() + "\nint main()\n{\n    return 0;\n}\n"));
    EXPECT_NE(first_message(report).find("main"), std::string::npos);
    EXPECT_EQ(report.at("policy").at("earned_without"), 20);
    EXPECT_EQ(report.at("unofficial").at("earned"), 20);
}

TEST(Upload, MayDefineWhatTheFrameworkDefines)
{
    Json const report = expect_zero(grade_text(
        reference_text() + "\nRay transform_ray(Ray const& ray, glm::mat4 const&)\n{\n    return ray;\n}\n"));
    EXPECT_NE(first_message(report).find("transform_ray"), std::string::npos);
}

class MissingFunction : public testing::TestWithParam<Function> {};

TEST_P(MissingFunction, CostsItsPointsBeforePolicy)
{
    std::string const name(info(GetParam()).name);
    Json const report = expect_zero(grade_text(without(reference_text(), GetParam())));
    EXPECT_NE(first_message(report).find(name), std::string::npos);
    for (auto const& [key, function] : report.at("functions").items()) {
        EXPECT_EQ(function.at("verdict"), key == name ? "missing" : "correct") << key;
        EXPECT_EQ(function.at("earned"), key == name ? Json(0.0) : function.at("max")) << key;
    }
    Json const& unofficial = report.at("unofficial");
    EXPECT_EQ(unofficial.at("earned"), report.at("policy").at("earned_without"));
    EXPECT_EQ(unofficial.at("earned"), unofficial.at("max"));
    EXPECT_EQ(unofficial.at("broken").size(), 1u);
    EXPECT_EQ(unofficial.at("broken").at(name).at("message"), first_message(report));
}

INSTANTIATE_TEST_SUITE_P(Upload, MissingFunction,
                         testing::Values(Function::wrap_clamp, Function::create_mipmap, Function::intersect,
                                         Function::transform_position),
                         [](auto const& p) { return std::string(testat::info(p.param).name); });

TEST(Upload, MayDeclareAFunctionDifferently)
{
    std::string const text = without(reference_text(), Function::transform_position) +
                             "glm::vec3 transform_position(glm::mat4 const& m, glm::vec4 const& p)\n"
                             "{\n    return glm::vec3(m * p);\n}\n";
    Json const report = expect_zero(grade_text(text));
    EXPECT_NE(first_message(report).find("transform_position"), std::string::npos);
    EXPECT_NE(first_message(report).find("glm::vec4"), std::string::npos) << first_message(report);
    EXPECT_EQ(report.at("functions").at("transform_position").at("verdict"), "missing");
}

TEST(Upload, MayDeclareAMemberDifferently)
{
    std::string const text = without(reference_text(), Function::wrap_repeat) +
                             "unsigned ImageTexture::wrap_repeat(unsigned val, unsigned size)\n"
                             "{\n    return val % size;\n}\n";
    EXPECT_NE(first_message(expect_zero(grade_text(text))).find("wrap_repeat"), std::string::npos);
}

class Compiler : public testing::TestWithParam<std::string> {};

TEST_P(Compiler, NamesTheLineOfAMistakeInTheUpload)
{
    Json const report = expect_zero(grade_text(
        "// one\n// two\n#include <cglib/rt/object.h>\nint x = ;\n" + reference_text(), {"--compiler", GetParam()}));
    Json const& first = report.at("build").at("diagnostics").at(0);
    EXPECT_EQ(first.at("file"), "exercise_03.cpp");
    EXPECT_EQ(first.at("line"), 4);
    EXPECT_EQ(first.at("severity"), "error");
    EXPECT_EQ(report.at("unofficial").at("left_out").at(0).at("line"), 4);
    EXPECT_EQ(report.at("unofficial").at("earned"), 20);
}

TEST_P(Compiler, SaysWhichIncludeIsMissing)
{
    std::string const text = "#include \"my_helpers.h\"\n" + reference_text();
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    EXPECT_NE(first_message(report).find("my_helpers.h"), std::string::npos);
    EXPECT_EQ(report.at("build").at("diagnostics").at(0).at("line"), 1);
}

/// One that everything needs, with a letter missing.
TEST_P(Compiler, ReadsTheHeaderWhoseNameIsMisspelt)
{
    std::string text = reference_text();
    std::string const name = "cglib/rt/texture.h";
    text.replace(text.find(name), name.size(), "cglib/rt/textur.h");
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    EXPECT_NE(report.at("unofficial").at("left_out").at(0).at("message").dump().find("textur.h"), std::string::npos);
    EXPECT_EQ(report.at("unofficial").at("earned"), 20);
}

TEST_P(Compiler, SaysWhichFunctionIsUndefined)
{
    std::string const text = "int nowhere(int);\n" + patched_reference(
                                                         "int ImageTexture::wrap_clamp(int val, int)\n"
                                                         "{\n    return nowhere(val);\n}\n");
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    EXPECT_NE(first_message(report).find("nowhere"), std::string::npos);
    EXPECT_EQ(report.at("unofficial").at("earned"), 19);
}

/// Compilers quote the lines they complain about, from whichever file #line names.
TEST_P(Compiler, QuotesNoFileThatALineDirectiveNames)
{
    TemporaryDirectory const place;
    write_file(place.path() / "secret.txt", "x:1:1: error: the answer is 42\n");
    std::string const text =
        "#line 1 \"" + (place.path() / "secret.txt").string() + "\"\nint x = ;\n" + reference_text();
    Graded const graded = grade_text(text, {"--compiler", GetParam()});
    expect_zero(graded);
    EXPECT_EQ(graded.report.dump().find("the answer is"), std::string::npos) << graded.report.at("build");
    for (auto const& d : graded.report.at("build").at("diagnostics"))
        EXPECT_EQ(d.at("file").get<std::string>().find('/'), std::string::npos) << d;
}

TEST_P(Compiler, GetsNoEscapeSequencesIntoTheReport)
{
    std::string const text = "#line 1 \"\\033[2Jfile\"\nint x = ;\n" + reference_text();
    Graded const graded = grade_text(text, {"--compiler", GetParam()});
    EXPECT_EQ(graded.out.find('\x1b'), std::string::npos);
    for (auto const& d : graded.report.at("build").at("diagnostics"))
        for (char const* key : {"file", "message"})
            EXPECT_EQ(d.at(key).get<std::string>().find('\x1b'), std::string::npos) << d;
}

/// The template with an error in one function: nobody has written the others.
TEST_P(Compiler, EarnsNothingUnofficiallyForTheTemplate)
{
    std::string const text =
        replace_body(read_file(template_file()), Function::create_mipmap, "{ mip_levels.push_back(level) }");
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    Json const& unofficial = report.at("unofficial");
    EXPECT_EQ(unofficial.at("earned"), 0);
    EXPECT_EQ(unofficial.at("max"), 18);
    for (auto const& [name, function] : unofficial.at("functions").items())
        EXPECT_EQ(function.at("verdict"), "missing") << name;
}

TEST_P(Compiler, BlamesTheFunctionWithASurplusBrace)
{
    std::string const text = replace_body(reference_text(), Function::wrap_repeat,
                                          "{\n    if (val < 0) }\n        val = 0;\n    }\n    return val;\n}");
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    EXPECT_EQ(report.at("unofficial").at("earned"), 19);
    EXPECT_TRUE(report.at("unofficial").at("broken").contains("wrap_repeat"));
}

/// It makes the error seem to lie in another function.
TEST_P(Compiler, BlamesNoLineThatALineDirectiveNames)
{
    int const line = find_definitions(reference_text()).at(0).line;
    std::string const text = replace_body(reference_text(), Function::wrap_repeat,
                                          "{\n#line " + std::to_string(line) + "\nreturn unknown;\n}");
    Json const report = expect_zero(grade_text(text, {"--compiler", GetParam()}));
    Json const& broken = report.at("unofficial").at("broken");
    EXPECT_EQ(broken.size(), 1u);
    ASSERT_TRUE(broken.contains("wrap_repeat")) << broken;
    EXPECT_GT(broken.at("wrap_repeat").at("line"), line);
}

TEST_P(Compiler, HasNothingUnofficialOfElevenBrokenFunctions)
{
    std::string text = reference_text();
    for (Function f : every_function())
        text = replace_body(text, f, "{ return unknown; }");
    EXPECT_FALSE(expect_zero(grade_text(text, {"--compiler", GetParam()})).contains("unofficial"));
}

INSTANTIATE_TEST_SUITE_P(Diagnostics, Compiler, testing::ValuesIn(compilers()),
                         [](auto const& p) { return p.param == "g++" ? "gcc" : "clang"; });

/// Points of the tasks that are graded, errors of all functions.
TEST(Upload, HasUnofficialPointsOfTheChosenTasks)
{
    std::string const text = replace_body(reference_text(), Function::evaluate_bilinear, "{ return unknown; }");
    Json const report = grade_text(text, {"--tasks", "b"}).report;
    EXPECT_EQ(report.at("points").at("earned"), 0);
    EXPECT_EQ(report.at("unofficial").at("earned"), 2);
    EXPECT_EQ(report.at("unofficial").at("max"), 2);
    EXPECT_TRUE(report.at("unofficial").at("broken").contains("evaluate_bilinear"));
}

/// The rescued functions are asked as usual: what they do wrong is told.
TEST(Upload, ShowsUnofficialPointsToStudents)
{
    std::string const text =
        replace_body(replace_body(reference_text(), Function::evaluate_bilinear, "{ return unknown; }"),
                     Function::wrap_repeat, "{ return 0 * (val + size); }");
    Graded const german = grade_text(text, {"--lang", "de", "--profile", "student"});
    expect_zero(german);
    for (char const* part :
         {"0.00 von 20.00 Punkten", "was nicht kompiliert, bekommt 0 Punkte", "evaluate_bilinear, Zeile ",
          "Inoffiziell", "kompiliert nicht", "wrap_repeat: WrapRepeat."})
        EXPECT_NE(german.out.find(part), std::string::npos) << part << " is not in\n" << german.out;
}

/// The precompiled header must not make up for an #include that is missing.
TEST(Upload, MustIncludeWhatItUses)
{
    std::string text = reference_text();
    for (std::string const header : {"object", "transform"}) {
        std::string const line = "#include <cglib/rt/" + header + ".h>\n";
        ASSERT_NE(text.find(line), std::string::npos);
        text.erase(text.find(line), line.size());
    }
    for (auto const& compiler : compilers())
        expect_zero(grade_text(text, {"--compiler", compiler}));
}
}  // namespace
}  // namespace testat
