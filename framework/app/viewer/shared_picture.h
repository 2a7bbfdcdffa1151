#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/prepared_render.h>
#include <cglib/rt/render_stats.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace viewer {

/// How far a picture is.
struct PictureProgress {
    /// Of its pixels, from 0 to 1.
    float fraction = 0.f;
    /// All pixels are there, or there is an error.
    bool finished = false;
    /// What went wrong, for people. Empty if nothing did.
    std::string error;
    /// Since the picture was asked for.
    double seconds = 0.;
    /// Of the pixels that are there, without those of the first impression.
    RenderStats stats;
};

/// What take_changes has found.
struct PictureChanges {
    PictureProgress progress;
    /// Where pixels have changed since the last time.
    std::vector<Tile> parts;
};

/// A picture that several threads make and one looks at. Whole parts change at a time. What is made belongs to a
/// generation, that is a request for a picture; tiles and news of another one than the latest are dropped.
class SharedPicture {
public:
    /// From now on the picture is that of this generation.
    void begin(std::uint64_t generation);

    /// A coarse version of the whole picture, of whatever generation: each of its pixels is shown as a square of `side`
    /// pixels. The picture becomes width x height.
    void show_coarse(Image const& coarse, int side, int width, int height);

    /// What its preparation took, which belongs to no tile.
    void add_stats(std::uint64_t generation, RenderStats const& stats);

    /// The canvas has the picture's size; of it, this tile is finished.
    void show_tile(std::uint64_t generation, Image const& canvas, Tile const& tile, RenderStats const& stats);

    /// All tiles are there, or (error not empty) there will be no more.
    void finish(std::uint64_t generation, std::string const& error);

    /// Copies the parts that have changed since the last call into *picture, which must be what the last call made of
    /// it; everything if its size is not that of the picture.
    PictureChanges take_changes(Image* picture);

private:
    void update_time();

    std::mutex mutex_;
    std::uint64_t generation_ = 0;
    std::chrono::steady_clock::time_point begin_;
    Image picture_;
    PictureProgress progress_;
    std::vector<Tile> parts_;
};

}  // namespace viewer
