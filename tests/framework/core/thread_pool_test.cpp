#include <cglib/core/thread_pool.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

TEST(ThreadPool, EachTaskRunsOnce)
{
    for (int threads : {1, 2, 5}) {
        ThreadPool pool(threads);
        for (int count : {0, 1, 3, 100}) {
            std::vector<std::atomic<int>> calls(std::size_t(count) + 1);
            pool.run(count, [&](int i) { ++calls[std::size_t(i)]; });
            for (int i = 0; i <= count; ++i)
                EXPECT_EQ(calls[std::size_t(i)], i < count ? 1 : 0);
        }
    }
}

TEST(ThreadPool, ExceptionReachesTheCaller)
{
    ThreadPool pool(3);
    auto const task = [](int i) {
        if (i == 5)
            throw std::runtime_error("five");
    };
    EXPECT_THROW(pool.run(50, task), std::runtime_error);
    EXPECT_NO_THROW(pool.run(4, task));
}
