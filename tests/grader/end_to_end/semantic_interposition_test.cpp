// Why uploads are compiled with -fsemantic-interposition: without it, calls between a student's functions stay inside
// the file, and a function is judged together with those that it calls.
#include "end_to_end/testat_program.h"

#include "checks/check.h"
#include "installation.h"
#include "observe/observe.h"
#include "source/definitions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
std::string const canary = "EvaluateTrilinear.BetweenLevels";

/// As compile/ does it, but for `flag`.
std::filesystem::path build(std::string const& compiler, std::string const& flag, std::filesystem::path const& place)
{
    auto const& where = installation();
    write_file(
        place / "upload.cpp",
        "#include <cstdlib>\n" + replace_body(reference_text(), Function::evaluate_bilinear, "{ std::abort(); }"));
    Command call;
    call.directory = place;
    call.argv = {compiler,
                 "-std=c++17",
                 "-O1",
                 "-fPIC",
                 flag,
                 "-DGLM_ENABLE_EXPERIMENTAL",
                 "-I" + where.include.string(),
                 "-shared",
                 "upload.cpp",
                 "-o",
                 "upload.so",
                 (where.libraries / "libtestat_trampolines.so").string(),
                 (where.libraries / "libtestat_framework.so").string()};
    Finished const finished = run(call);
    EXPECT_EQ(finished.exit_code, 0) << finished.output;
    return place / "upload.so";
}

/// How evaluate_trilinear of an upload fares whose evaluate_bilinear aborts.
GroupStatus ask(std::string const& compiler, std::string const& flag)
{
    TemporaryDirectory const place;
    Build built;
    built.library = build(compiler, flag, place.path());
    Request request{{}, {}, make_test_textures(1), {}};
    auto const check =
        std::find_if(unit_checks().begin(), unit_checks().end(), [](auto const& c) { return c.name == canary; });
    Random random(1, canary);
    request.groups.push_back(check->ask(random, request.textures));
    request.groups[0].name = canary;
    request.groups[0].under_test = check->function;
    request.groups[0].from_upload = FunctionSet::only(check->function);
    Cage cage(Confinement::none);
    return observe(built, request, installation(), cage).groups.at(canary).status;
}

class SemanticInterposition : public testing::TestWithParam<std::string> {};

TEST_P(SemanticInterposition, LetsTheReferenceStandIn)
{
    EXPECT_EQ(ask(GetParam(), "-fsemantic-interposition").ended, Ended::answered);
}

TEST_P(SemanticInterposition, IsMissedByTheCanary)
{
    GroupStatus const status = ask(GetParam(), "-fno-semantic-interposition");
    EXPECT_EQ(status.ended, Ended::signal);
    EXPECT_EQ(status.code, SIGABRT);
}

INSTANTIATE_TEST_SUITE_P(Compilers, SemanticInterposition, testing::ValuesIn(compilers()),
                         [](auto const& p) { return p.param == "g++" ? "gcc" : "clang"; });
}  // namespace
}  // namespace testat
