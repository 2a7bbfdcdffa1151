#pragma once

#include <cglib/core/thread_pool.h>

/// What ThreadPool needs of oneTBB. Apart from it because the thread sanitizer must not look in here: Debian's oneTBB
/// is not instrumented, and without what the library does its headers look like one race.
struct ThreadPool::Arena {
    /// num_threads >= 2 includes the calling thread.
    explicit Arena(int num_threads);
    ~Arena();
    Arena(Arena const&) = delete;
    Arena& operator=(Arena const&) = delete;

    using Call = void (*)(void const* body, int i);

    /// call(body, 0) ... call(body, count - 1) on all threads, see ThreadPool::run.
    void run(int count, Call call, void const* body);

private:
    struct Threads;
    std::unique_ptr<Threads> threads_;
};
