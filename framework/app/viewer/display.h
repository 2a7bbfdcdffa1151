#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/prepared_render.h>

#include <array>
#include <cstdint>
#include <vector>

namespace viewer {

/// How linear colours become those of the screen.
struct Exposure {
    /// Doublings of brightness.
    float stops = 0.f;
    /// 8-bit values are linear ones to the power of 1 / gamma.
    float gamma = 2.2f;

    bool operator==(Exposure const& other) const { return stops == other.stops && gamma == other.gamma; }
    bool operator!=(Exposure const& other) const { return !(*this == other); }
};

/// The image with its colours multiplied as the stops say.
Image exposed(Image image, Exposure const& exposure);

/// Turns colours into 8 bit as Image::save would do it with exposed(), to the nearest value but for a few close calls,
/// and much faster.
class DisplayCurve {
public:
    explicit DisplayCurve(Exposure const& exposure);

    /// NaN is shown as 0.
    std::uint8_t operator()(float linear) const;

private:
    std::array<std::uint8_t, 1u << 16> table_;
};

/// What is on the screen: 8-bit RGBA, rows from the bottom.
class DisplayPicture {
public:
    /// Brings the parts up to date; everything if size or exposure have changed. Whether anything has.
    bool update(Image const& image, std::vector<Tile> const& parts, Exposure const& exposure);

    /// In pixels.
    int width() const { return width_; }
    /// In pixels.
    int height() const { return height_; }
    /// Four for each pixel.
    std::vector<std::uint8_t> const& bytes() const { return bytes_; }

private:
    void convert_all(Image const& image, Exposure const& exposure);
    void convert(Image const& image, Tile const& tile);

    Exposure exposure_;
    DisplayCurve curve_{Exposure()};
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace viewer
