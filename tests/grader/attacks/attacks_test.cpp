// Every attack ends as its first line says; it gains nothing, hurts nobody and tells nothing. Twins are shared, so
// many run as one process.
#include "attacks/attack.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
class Attacks : public testing::TestWithParam<Attack> {
public:
    static void SetUpTestSuite() { before() = grade_next_upload(); }

    static void TearDownTestSuite()
    {
        EXPECT_FALSE(before().is_null());
        EXPECT_EQ(grade_next_upload(), before()) << "the next upload is graded otherwise";
    }

private:
    static Json& before()
    {
        static Json report;
        return report;
    }
};

TEST_P(Attacks, GainNothingAndHurtNobody)
{
    Trial const trial = try_attack(GetParam());
    for (auto const& complaint : trial.complaints)
        ADD_FAILURE() << GetParam().name << ": " << complaint;
}

INSTANTIATE_TEST_SUITE_P(Files, Attacks, testing::ValuesIn(all_attacks()),
                         [](auto const& instance) { return instance.param.name; });
}  // namespace
}  // namespace testat
