#include "progressive_render.h"

#include "tile_order.h"

#include <algorithm>
#include <chrono>

namespace viewer {
namespace {
int const coarse_side = 8;
int const tile_side = 32;
/// How many samples a thread takes before it looks whether they are still wanted.
int const samples_in_a_row = 512;
/// So long a first impression may take although it is outdated: while a camera is dragged about, every picture is
/// outdated before it is there, and one would see none.
std::chrono::milliseconds const patience(100);

RaytracingParameters with_one_sample(RaytracingParameters params)
{
    params.spp = 1;
    return params;
}

void set_size(Image* image, RaytracingParameters const& params)
{
    if (image->getWidth() != params.width || image->getHeight() != params.height)
        image->setSize(params.width, params.height);
}

int num_squares(int pixels)
{
    return (pixels + coarse_side - 1) / coarse_side;
}

/// The pixel that stands for a square: the one in its middle.
int representative(int square, int pixels)
{
    return std::min(square * coarse_side + coarse_side / 2, pixels - 1);
}
}  // namespace

ProgressiveRender::ProgressiveRender(int threads, std::function<void()> on_change)
    : threads_(threads), on_change_(std::move(on_change)), pool_(threads), coordinator_([this] { run(); })
{
}

ProgressiveRender::~ProgressiveRender()
{
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        stopping_ = true;
        ++generation_;
    }
    wake_.notify_one();
    coordinator_.join();
}

void ProgressiveRender::restart(RenderRequest request)
{
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        pending_ = Job{std::move(request), ++generation_};
        picture_.begin(generation_);
    }
    wake_.notify_one();
}

std::optional<ProgressiveRender::Job> ProgressiveRender::next_job()
{
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [this] { return stopping_ || pending_; });
    std::optional<Job> job;
    if (!stopping_)
        job.swap(pending_);
    return job;
}

void ProgressiveRender::run()
{
    while (std::optional<Job> const job = next_job()) {
        std::string error;
        try {
            render(*job);
        } catch (std::exception const& e) {
            error = e.what();
        } catch (...) {
            error = "something was thrown that is no std::exception";
        }
        if (is_stale(*job))
            continue;
        picture_.finish(job->generation, error);
        on_change_();
    }
}

void ProgressiveRender::render(Job const& job)
{
    job.scene->camera = job.camera;
    show_first_impression(job);
    if (is_stale(job))
        return;
    PreparedRender const prepared(*job.scene, job.params);
    picture_.add_stats(job.generation, prepared.preparation());
    render_tiles(job, prepared);
}

void ProgressiveRender::show_first_impression(Job const& job)
{
    RaytracingParameters const params = with_one_sample(job.params);
    PreparedRender const prepared(*job.scene, params);
    picture_.add_stats(job.generation, prepared.preparation());
    set_size(&canvas_, params);
    Image coarse(num_squares(params.width), num_squares(params.height));
    auto const deadline = std::chrono::steady_clock::now() + patience;
    auto const stop = [&] { return is_stale(job) && std::chrono::steady_clock::now() > deadline; };
    bool const complete = share(coarse.getHeight(), stop, [&](int j) {
        int const y = representative(j, params.height);
        for (int i = 0; i < coarse.getWidth(); ++i) {
            int const x = representative(i, params.width);
            prepared.render({x, y, x + 1, y + 1}, &canvas_);
            coarse.setPixel(i, j, canvas_.getPixel(x, y));
        }
    });
    if (!complete)
        return;
    picture_.show_coarse(coarse, coarse_side, params.width, params.height);
    on_change_();
}

void ProgressiveRender::render_tiles(Job const& job, PreparedRender const& prepared)
{
    std::vector<Tile> const tiles = tiles_from_centre(job.params.width, job.params.height, tile_side);
    share(
        int(tiles.size()), [&] { return is_stale(job); },
        [&](int i) { render_tile(job, prepared, tiles[std::size_t(i)]); });
}

void ProgressiveRender::render_tile(Job const& job, PreparedRender const& prepared, Tile const& tile)
{
    int const step = std::clamp(samples_in_a_row / std::max(1, job.params.spp), 1, tile_side);
    RenderStats stats;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += step) {
            if (is_stale(job))
                return;
            stats += prepared.render({x, y, std::min(x + step, tile.x1), y + 1}, &canvas_);
        }
    picture_.show_tile(job.generation, canvas_, tile, stats);
}

/// Calls task(0) ... task(count - 1) in this order on all threads, until stop() or an exception. Whether it called all.
bool ProgressiveRender::share(int count, std::function<bool()> const& stop, std::function<void(int)> const& task)
{
    // Relaxed: tasks have nothing to tell each other, and a race among them shall not be hidden from a sanitizer.
    auto const relaxed = std::memory_order_relaxed;
    std::atomic<int> next{0};
    std::atomic<bool> stopped{false};
    pool_.run(threads_, [&](int) {
        try {
            for (int i = next.fetch_add(1, relaxed); i < count && !stopped.load(relaxed);
                 i = next.fetch_add(1, relaxed))
                stop() ? stopped.store(true, relaxed) : task(i);
        } catch (...) {
            stopped.store(true, relaxed);
            throw;
        }
    });
    return !stopped;
}

}  // namespace viewer
