#include "arena.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

struct ThreadPool::Arena::Threads {
    explicit Threads(int num_threads)
        : limit(tbb::global_control::max_allowed_parallelism, std::size_t(num_threads)), arena(num_threads)
    {
    }
    /// Lets there be more threads than processors.
    tbb::global_control limit;
    tbb::task_arena arena;
};

ThreadPool::Arena::Arena(int num_threads) : threads_(std::make_unique<Threads>(num_threads)) {}

ThreadPool::Arena::~Arena() = default;

void ThreadPool::Arena::run(int count, Call call, void const* body)
{
    threads_->arena.execute([=] {
        tbb::parallel_for(
            0, count, [=](int i) { call(body, i); }, tbb::simple_partitioner());
    });
}
