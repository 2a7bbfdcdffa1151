#include <cglib/core/thread_pool.h>

#include <cglib/core/assert.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

struct ThreadPool::Arena {
    explicit Arena(int num_threads)
        : limit(tbb::global_control::max_allowed_parallelism, std::size_t(num_threads)), threads(num_threads)
    {
    }
    /// Lets there be more threads than processors.
    tbb::global_control limit;
    tbb::task_arena threads;
};

ThreadPool::ThreadPool(int num_threads)
{
    cg_assert(num_threads >= 1);
    if (num_threads > 1)
        arena_ = std::make_unique<Arena>(num_threads);
}

ThreadPool::~ThreadPool() = default;

void ThreadPool::run(int count, std::function<void(int)> const& task)
{
    if (!arena_) {
        for (int i = 0; i < count; ++i)
            task(i);
        return;
    }
    arena_->threads.execute([&] { tbb::parallel_for(0, count, task, tbb::simple_partitioner()); });
}
