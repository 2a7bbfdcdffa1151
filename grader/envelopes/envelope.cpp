#include "envelopes/envelope.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace testat {
namespace {
/// Farther apart than this, two values of a pixel are two texels and not one texel with roundings.
double gap(double value)
{
    return 1e-4 * (1 + std::abs(value));
}

/// How far a value lies outside a box, the largest channel, in units of the gap.
double distance(Box const& box, float const* rgb)
{
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        double const below = double(box.lo[c]) - rgb[c];
        double const above = double(rgb[c]) - box.hi[c];
        largest = std::max(largest, std::max(below, above) / gap(rgb[c]));
    }
    return largest;
}

void extend(Box& box, float const* rgb)
{
    for (int c = 0; c < 3; ++c) {
        box.lo[c] = std::min(box.lo[c], rgb[c]);
        box.hi[c] = std::max(box.hi[c], rgb[c]);
    }
}

Box widened(Box box)
{
    for (int c = 0; c < 3; ++c) {
        double const lo = box.lo[c];
        double const hi = box.hi[c];
        double const margin = 2e-6 + (hi - lo) / 2 + 1e-6 * std::max(std::abs(lo), std::abs(hi));
        box.lo[c] = float(lo - margin);
        box.hi[c] = float(hi + margin);
    }
    return box;
}

/// Where more texels than two take turns, as in the reflection on a ball, renderings do not find all of them: there
/// everything between them counts.
constexpr std::size_t most_texels = 2;

Box around(std::vector<Box> const& boxes)
{
    Box all = boxes.front();
    for (auto const& box : boxes) {
        extend(all, box.lo);
        extend(all, box.hi);
    }
    return all;
}

constexpr std::uint32_t magic = 0x31766e65;

template <typename T>
void put(std::ofstream& out, T const* data, std::size_t count)
{
    out.write(reinterpret_cast<char const*>(data), std::streamsize(count * sizeof(T)));
}

template <typename T>
void get(std::ifstream& in, T* data, std::size_t count)
{
    in.read(reinterpret_cast<char*>(data), std::streamsize(count * sizeof(T)));
}

struct Header {
    std::uint32_t magic;
    std::int32_t width;
    std::int32_t height;
    std::uint32_t boxes;
    double reference_ms;
};
}  // namespace

void EnvelopeBuilder::add_pixel(std::vector<Box>& boxes, float const* rgb) const
{
    auto const nearest = std::min_element(
        boxes.begin(), boxes.end(), [&](Box const& a, Box const& b) { return distance(a, rgb) < distance(b, rgb); });
    bool const fits = nearest != boxes.end() && (distance(*nearest, rgb) <= 1 || boxes.size() == most_boxes_);
    if (fits)
        extend(*nearest, rgb);
    else
        boxes.push_back({{rgb[0], rgb[1], rgb[2]}, {rgb[0], rgb[1], rgb[2]}});
}

void EnvelopeBuilder::add(Picture const& rendering)
{
    if (pixels_.empty()) {
        expected_ = rendering;
        pixels_.resize(rendering.rgb.size() / 3);
    }
    if (rendering.rgb.size() != expected_.rgb.size())
        throw std::runtime_error("envelope: renderings of different sizes");
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        add_pixel(pixels_[i], &rendering.rgb[3 * i]);
}

Envelope EnvelopeBuilder::finish(double reference_ms) const
{
    Envelope envelope{expected_, {0}, {}, reference_ms};
    for (auto const& boxes : pixels_) {
        if (boxes.size() > most_texels)
            envelope.boxes.push_back(widened(around(boxes)));
        else
            for (auto const& box : boxes)
                envelope.boxes.push_back(widened(box));
        envelope.first.push_back(std::uint32_t(envelope.boxes.size()));
    }
    return envelope;
}

void write_envelope(Envelope const& envelope, std::filesystem::path const& file)
{
    std::ofstream out(file, std::ios::binary);
    Header const header{magic, envelope.expected.width, envelope.expected.height, std::uint32_t(envelope.boxes.size()),
                        envelope.reference_ms};
    put(out, &header, 1);
    put(out, envelope.expected.rgb.data(), envelope.expected.rgb.size());
    put(out, envelope.first.data(), envelope.first.size());
    put(out, envelope.boxes.data(), envelope.boxes.size());
    if (!out.flush())
        throw std::runtime_error("cannot write " + file.string());
}

Envelope read_envelope(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    Header header{};
    get(in, &header, 1);
    if (!in || header.magic != magic || header.width < 1 || header.height < 1)
        throw std::runtime_error(file.string() + ": no envelope; build again");
    std::size_t const pixels = std::size_t(header.width) * std::size_t(header.height);
    Envelope envelope;
    envelope.expected = {header.width, header.height, std::vector<float>(3 * pixels)};
    envelope.first.resize(pixels + 1);
    envelope.boxes.resize(header.boxes);
    envelope.reference_ms = header.reference_ms;
    get(in, envelope.expected.rgb.data(), envelope.expected.rgb.size());
    get(in, envelope.first.data(), envelope.first.size());
    get(in, envelope.boxes.data(), envelope.boxes.size());
    bool const in_order = std::is_sorted(envelope.first.begin(), envelope.first.end());
    if (!in || !in_order || envelope.first.back() != header.boxes)
        throw std::runtime_error(file.string() + ": damaged; build again");
    return envelope;
}
}  // namespace testat
