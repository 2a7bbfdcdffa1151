#include <cglib/core/thread_pool.h>

#include <cglib/core/assert.h>

ThreadPool::ThreadPool(int num_threads)
{
    cg_assert(num_threads >= 1);
    for (int i = 1; i < num_threads; ++i)
        threads_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool()
{
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        stop_ = true;
    }
    start_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void ThreadPool::run(int count, std::function<void(int)> const& task)
{
    std::unique_lock<std::mutex> lock(mutex_);
    task_ = task;
    error_ = nullptr;
    next_ = 0;
    count_ = count;
    start_.notify_all();
    take_tasks(lock);
    finished_.wait(lock, [this] { return running_ == 0; });
    if (error_)
        std::rethrow_exception(error_);
}

void ThreadPool::work()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        start_.wait(lock, [this] { return stop_ || next_ < count_; });
        if (stop_)
            return;
        take_tasks(lock);
    }
}

void ThreadPool::take_tasks(std::unique_lock<std::mutex>& lock)
{
    while (next_ < count_) {
        ++running_;
        call_task(next_++, lock);
        --running_;
    }
    if (running_ == 0)
        finished_.notify_one();
}

void ThreadPool::call_task(int index, std::unique_lock<std::mutex>& lock)
{
    lock.unlock();
    std::exception_ptr error;
    try {
        task_(index);
    } catch (...) {
        error = std::current_exception();
    }
    lock.lock();
    if (error && !error_)
        error_ = error;
    if (error)
        count_ = next_;
}
