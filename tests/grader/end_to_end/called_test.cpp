// Which functions a picture needs is known beforehand: the pictures themselves say whether that is right.
#include "checks/pictures.h"
#include "compile/compile.h"
#include "end_to_end/testat_program.h"
#include "envelopes/pictures.h"
#include "installation.h"
#include "observe/observe.h"
#include "rubric/rubric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
namespace {
std::string name_of(std::string const& picture, Function f)
{
    return picture + "/" + std::string(info(f).name);
}

/// Every picture with each of the functions that may have a hand in it from the upload, the others from the reference.
Request ask_each(Rubric const& rubric)
{
    Request request{{10, 10, 600}, FunctionSet(), {}, {}};
    for (auto const& [picture, functions] : pictures_of(rubric))
        for (Function f : every_function())
            if (functions_in(picture).has(f)) {
                Group group = picture_group(picture);
                group.name = name_of(picture, f);
                group.from_upload = FunctionSet::only(f);
                request.groups.push_back(std::move(group));
            }
    return request;
}
}  // namespace

TEST(CalledIn, NamesWhatAPictureIsWrongWithout)
{
    Installation const& where = installation();
    Rubric const rubric = read_rubric(where.rubric);
    Cage cage(Confinement::cage, {HUGE_VAL, HUGE_VAL});
    TemporaryDirectory const place;
    Build const build = compile(read_submission(template_file()), {}, place.path(), where, cage);
    Observations const observations = observe(build, ask_each(rubric), where, cage);
    for (auto const& [picture, functions] : pictures_of(rubric)) {
        Envelope const envelope = read_envelope(where.envelopes / (picture + ".envelope"));
        for (Function f : every_function())
            if (functions_in(picture).has(f)) {
                auto const rendering = judge_rendering(picture, name_of(picture, f), observations, envelope);
                EXPECT_EQ(rendering.comparison.score < 1, called_in(picture).has(f)) << name_of(picture, f);
            }
    }
}
}  // namespace testat
