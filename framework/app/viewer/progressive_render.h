#pragma once

#include "shared_picture.h"

#include <cglib/core/camera.h>
#include <cglib/core/thread_pool.h>
#include <cglib/rt/prepared_render.h>
#include <cglib/rt/scene.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace viewer {

/// A picture to be made.
struct RenderRequest {
    /// Once handed over, it belongs to the render: textures are loaded into it, its camera is set.
    std::shared_ptr<Scene> scene;
    Camera camera;
    RaytracingParameters params;
};

/// Renders in the background: first every eighth pixel, then tiles from the centre outward. What it makes can be looked
/// at any time, and is render_scene's picture when it is finished. All functions are for one thread, and none waits for
/// rays.
class ProgressiveRender {
public:
    /// on_change is called when there is a first impression of a picture, and when it is finished or has failed; on
    /// another thread.
    ProgressiveRender(int threads, std::function<void()> on_change);

    /// Drops what is under way.
    ~ProgressiveRender();

    ProgressiveRender(ProgressiveRender const&) = delete;
    ProgressiveRender& operator=(ProgressiveRender const&) = delete;

    /// Drops what is under way and starts another picture. Until there is a first impression of it, the last picture
    /// stays.
    void restart(RenderRequest request);

    /// Brings a copy of the picture up to date, see SharedPicture::take_changes. What went wrong, such as a missing
    /// texture, is in the result's `error`.
    PictureChanges take_changes(Image* picture) { return picture_.take_changes(picture); }

private:
    struct Job : RenderRequest {
        std::uint64_t generation;
    };

    void run();
    std::optional<Job> next_job();
    bool is_stale(Job const& job) const { return generation_ != job.generation; }
    void render(Job const& job);
    void show_first_impression(Job const& job);
    void render_tiles(Job const& job, PreparedRender const& prepared);
    void render_tile(Job const& job, PreparedRender const& prepared, Tile const& tile);
    bool share(int count, std::function<bool()> const& stop, std::function<void(int)> const& task);

    int threads_;
    std::function<void()> on_change_;
    ThreadPool pool_;
    SharedPicture picture_;
    /// What tiles are rendered into, each by one thread.
    Image canvas_;

    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Job> pending_;
    bool stopping_ = false;
    /// Of the latest request. Changes under the mutex, read by tiles without.
    std::atomic<std::uint64_t> generation_{0};
    std::thread coordinator_;
};

}  // namespace viewer
