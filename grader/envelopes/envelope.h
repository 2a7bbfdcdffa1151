#pragma once
#include "model.h"

namespace testat {
/// What correct solutions may show in a pixel (GRADING.md, section 4): the RGB boxes that renderings of the perturbed
/// reference fall into. One box where the filter is continuous, two where it is nearest and the texel may jump; where
/// it jumps among more, one around them all.
struct Box {
    float lo[3];
    float hi[3];
};

struct Envelope {
    Picture expected;                  ///< the reference itself
    std::vector<std::uint32_t> first;  ///< pixels + 1: boxes of pixel i are first[i] to first[i + 1]
    std::vector<Box> boxes;
    double reference_ms = 0;  ///< CPU time of the reference for this picture

    /// Whether a pixel of the picture lies in none of its boxes. NaN lies in none.
    bool is_outside(float const* rgb, std::size_t pixel) const
    {
        for (std::uint32_t b = first[pixel]; b < first[pixel + 1]; ++b)
            if (contains(boxes[b], rgb))
                return false;
        return true;
    }

    static bool contains(Box const& box, float const* rgb)
    {
        for (int c = 0; c < 3; ++c)
            if (!(rgb[c] >= box.lo[c] && rgb[c] <= box.hi[c]))
                return false;
        return true;
    }
};

/// Grows an envelope from renderings of one size. The first rendering is the expected one.
class EnvelopeBuilder {
public:
    explicit EnvelopeBuilder(std::size_t most_boxes) : most_boxes_(most_boxes) {}
    void add(Picture const& rendering);

    /// Widens every box by 2e-6 + (hi - lo) / 2 + 1e-6 |x| on either side.
    Envelope finish(double reference_ms) const;

private:
    void add_pixel(std::vector<Box>& boxes, float const* rgb) const;

    std::size_t most_boxes_;
    Picture expected_;
    std::vector<std::vector<Box>> pixels_;
};

/// Binary files, for this machine only. Reading throws std::runtime_error if the file is missing or damaged.
void write_envelope(Envelope const& envelope, std::filesystem::path const& file);
Envelope read_envelope(std::filesystem::path const& file);
}  // namespace testat
