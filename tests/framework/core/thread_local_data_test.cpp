#include <cglib/core/thread_local_data.h>

#include <gtest/gtest.h>

TEST(ThreadLocalData, SameSeedGivesSameNumbers)
{
    ThreadLocalData a(7);
    ThreadLocalData b;
    b.set_seed(7);
    EXPECT_EQ(a.rand(), b.rand());
    EXPECT_NE(a.rand(), ThreadLocalData(8).rand());
}

TEST(ThreadLocalData, NumbersFillTheUnitInterval)
{
    ThreadLocalData thread(1);
    int counts[4] = {};
    for (int i = 0; i < 4000; ++i)
        ++counts[int(4.f * thread.rand())];
    for (int count : counts)
        EXPECT_NEAR(count, 1000, 150);
}
