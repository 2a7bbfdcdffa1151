#include "progress.h"

#include <gtest/gtest.h>

namespace testat {
TEST(Progress, SaysHowMuchIsDoneAndHowLongTheRestTakes)
{
    EXPECT_EQ(progress_line("Envelopes", 5, 20, 10, "plane_after_c"),
              "Envelopes  [######------------------]  5/20  30 s left  plane_after_c");
}

TEST(Progress, PromisesNothingBeforeTheFirstStepAndAfterTheLast)
{
    EXPECT_EQ(progress_line("Work", 0, 2, 1, ""), "Work  [------------------------]  0/2  ");
    EXPECT_EQ(progress_line("Work", 2, 2, 1, "end"), "Work  [########################]  2/2  end");
}

TEST(Progress, OfNothingIsDone)
{
    EXPECT_EQ(progress_line("Work", 0, 0, 1, ""), "Work  [########################]  0/0  ");
}
}  // namespace testat
