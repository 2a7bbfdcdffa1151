#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

/// Threads that wait for work. One caller at a time.
class ThreadPool {
public:
    /// num_threads >= 1 (asserted) includes the calling thread: a pool of one starts no thread at all.
    explicit ThreadPool(int num_threads);

    /// Ends the threads.
    ~ThreadPool();

    ThreadPool(ThreadPool const&) = delete;
    ThreadPool& operator=(ThreadPool const&) = delete;

    /// Calls task(0) ... task(count - 1), each once, in any order and on all threads; returns when all are done.
    /// After an exception no further task is started; the first one is thrown on to the caller.
    void run(int count, std::function<void(int)> const& task);

private:
    void work();
    void take_tasks(std::unique_lock<std::mutex>& lock);
    void call_task(int index, std::unique_lock<std::mutex>& lock);

    std::mutex mutex_;
    std::condition_variable start_;
    std::condition_variable finished_;
    std::function<void(int)> task_;
    std::exception_ptr error_;
    int next_ = 0;
    int count_ = 0;
    int running_ = 0;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};
