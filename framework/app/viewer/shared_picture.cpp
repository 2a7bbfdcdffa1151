#include "shared_picture.h"

#include <algorithm>

namespace viewer {
namespace {
bool same_size(Image const& a, Image const& b)
{
    return a.getWidth() == b.getWidth() && a.getHeight() == b.getHeight();
}

Tile whole(Image const& image)
{
    return {0, 0, image.getWidth(), image.getHeight()};
}

void copy(Image const& from, Tile const& tile, Image* to)
{
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            to->setPixel(x, y, from.getPixel(x, y));
}

float share_of(Tile const& tile, Image const& picture)
{
    float const pixels = float(tile.x1 - tile.x0) * float(tile.y1 - tile.y0);
    return pixels / (float(picture.getWidth()) * float(picture.getHeight()));
}
}  // namespace

void SharedPicture::begin(std::uint64_t generation)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    generation_ = generation;
    begin_ = std::chrono::steady_clock::now();
    progress_ = PictureProgress();
}

void SharedPicture::update_time()
{
    progress_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void SharedPicture::show_coarse(Image const& coarse, int side, int width, int height)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    if (picture_.getWidth() != width || picture_.getHeight() != height)
        picture_.setSize(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture_.setPixel(x, y, coarse.getPixel(x / side, y / side));
    parts_ = {whole(picture_)};
}

void SharedPicture::add_stats(std::uint64_t generation, RenderStats const& stats)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    if (generation == generation_)
        progress_.stats += stats;
}

void SharedPicture::show_tile(std::uint64_t generation, Image const& canvas, Tile const& tile, RenderStats const& stats)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    if (generation != generation_)
        return;
    copy(canvas, tile, &picture_);
    parts_.push_back(tile);
    progress_.stats += stats;
    progress_.fraction += share_of(tile, picture_);
    update_time();
}

void SharedPicture::finish(std::uint64_t generation, std::string const& error)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    if (generation != generation_)
        return;
    progress_.finished = true;
    progress_.error = error;
    if (error.empty())
        progress_.fraction = 1.f;
    update_time();
}

PictureChanges SharedPicture::take_changes(Image* picture)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    PictureChanges changes{progress_, {}};
    changes.parts.swap(parts_);
    if (!same_size(*picture, picture_)) {
        *picture = picture_;
        changes.parts = {whole(picture_)};
    }
    for (Tile const& tile : changes.parts)
        copy(picture_, tile, picture);
    return changes;
}

}  // namespace viewer
