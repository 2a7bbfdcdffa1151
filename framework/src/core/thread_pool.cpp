#include <cglib/core/thread_pool.h>

#include "arena.h"

#include <cglib/core/assert.h>

#include <atomic>

namespace {
/// What the threads of a run call. oneTBB makes all that happened before run visible to the tasks, and their work to
/// the caller; here it is said once more, where the thread sanitizer sees it. There are two marks because one would
/// order the tasks among themselves, and hide their races.
class Body {
public:
    explicit Body(std::function<void(int)> const& task) : task_(task) { begun_.store(true, std::memory_order_release); }
    ~Body() { static_cast<void>(ended_.load(std::memory_order_acquire)); }
    Body(Body const&) = delete;
    Body& operator=(Body const&) = delete;

    static void call(void const* body, int i) { static_cast<Body const*>(body)->run(i); }

private:
    /// Also after an exception.
    struct End {
        ~End() { tasks.fetch_add(1, std::memory_order_release); }
        std::atomic<int>& tasks;
    };

    void run(int i) const
    {
        static_cast<void>(begun_.load(std::memory_order_acquire));
        End const end{ended_};
        task_(i);
    }

    std::function<void(int)> const& task_;
    std::atomic<bool> begun_{false};
    mutable std::atomic<int> ended_{0};
};
}  // namespace

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
    Body const body(task);
    arena_->run(count, &Body::call, &body);
}
