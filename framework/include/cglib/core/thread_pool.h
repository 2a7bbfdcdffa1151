#pragma once

#include <functional>
#include <memory>

/// Threads for work that falls into parts (those of oneTBB). One caller at a time.
class ThreadPool {
public:
    /// num_threads >= 1 (asserted) includes the calling thread: a pool of one starts no thread at all.
    explicit ThreadPool(int num_threads);

    /// The threads are done by then.
    ~ThreadPool();

    ThreadPool(ThreadPool const&) = delete;
    ThreadPool& operator=(ThreadPool const&) = delete;

    /// Calls task(0) ... task(count - 1), each once, in any order and on all threads; returns when all are done.
    /// After an exception no further task is started; one of those thrown is passed on to the caller.
    void run(int count, std::function<void(int)> const& task);

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};
