#include <cglib/core/assert.h>

#include <gtest/gtest.h>

TEST(AssertDeathTest, FailureNamesExpressionAndPlace)
{
    EXPECT_DEATH(cg_assert(1 + 1 == 3), "assert_test.cpp:6?.*1 \\+ 1 == 3");
}

TEST(Assert, TrueExpressionIsEvaluatedOnce)
{
    int calls = 0;
    cg_assert(++calls == 1);
    EXPECT_EQ(calls, 1);
}
