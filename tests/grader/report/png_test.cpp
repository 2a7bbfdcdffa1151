#include "report/png.h"

#include "grey_picture.h"

#include <gtest/gtest.h>
#include <spng.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace testat {
namespace {
struct Decoded {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb;
};

Decoded decode(std::string const& png)
{
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> const context(spng_ctx_new(0), spng_ctx_free);
    spng_set_png_buffer(context.get(), png.data(), png.size());
    spng_ihdr header{};
    std::size_t size = 0;
    EXPECT_EQ(spng_get_ihdr(context.get(), &header), 0);
    EXPECT_EQ(spng_decoded_image_size(context.get(), SPNG_FMT_RGB8, &size), 0);
    Decoded decoded{header.width, header.height, std::vector<std::uint8_t>(size)};
    EXPECT_EQ(spng_decode_image(context.get(), decoded.rgb.data(), size, SPNG_FMT_RGB8, 0), 0);
    return decoded;
}

/// 255 x^(1/gamma), before rounding.
double shown(float value, double gamma)
{
    return 255 * std::pow(std::min(1.0, std::max(0.0, double(value))), 1 / gamma);
}

/// Halves may go either way, as far as a float can tell.
void expect_rounded(float value, double gamma)
{
    ASSERT_NEAR(to_8_bits(value, gamma != 1), shown(value, gamma), 0.5 + 1e-4) << value << ", gamma " << gamma;
}
}  // namespace

TEST(To8Bits, AgreesWithThePower)
{
    for (unsigned seed = 0; seed < 100'000; ++seed) {
        std::mt19937 engine(seed);
        float const value = float(std::pow(2, -14.0 * double(engine()) / double(std::mt19937::max()))) * 1.1f;
        expect_rounded(value, 1);
        expect_rounded(value, 2.2);
    }
}

TEST(To8Bits, ReachesEveryByteInOrder)
{
    for (bool gamma : {false, true}) {
        int last = 0;
        for (int i = 0; i <= 1'000'000; ++i) {
            int const byte = to_8_bits(float(i) / 1e6f, gamma);
            ASSERT_TRUE(byte == last || byte == last + 1) << i;
            last = byte;
        }
        EXPECT_EQ(last, 255);
    }
}

TEST(To8Bits, EndsAtBlackAndWhite)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (bool gamma : {false, true}) {
        for (float dark : {0.f, -0.f, -1.f, -infinity, std::numeric_limits<float>::denorm_min()})
            EXPECT_EQ(to_8_bits(dark, gamma), 0) << dark;
        for (float bright : {1.f, 1.5f, 1e30f, infinity})
            EXPECT_EQ(to_8_bits(bright, gamma), 255) << bright;
    }
}

TEST(To8Bits, ShowsNaNWhite)
{
    EXPECT_EQ(to_8_bits(NAN, false), 255);
    EXPECT_EQ(to_8_bits(-NAN, true), 255);
}

TEST(EncodePng, ComesBackTopRowFirst)
{
    Decoded const decoded = decode(encode_png({1, 2, {0, 0.2f, 0.4f, 0.6f, 0.8f, 1}}, false));
    EXPECT_EQ(decoded.width, 1u);
    EXPECT_EQ(decoded.height, 2u);
    EXPECT_EQ(decoded.rgb, (std::vector<std::uint8_t>{153, 204, 255, 0, 51, 102}));
}

TEST(EncodePng, AppliesTheGamma)
{
    EXPECT_EQ(decode(encode_png(grey_picture(1, 1, 0.5f), true)).rgb, std::vector<std::uint8_t>(3, 186));
    EXPECT_EQ(decode(encode_png(grey_picture(1, 1, 0.5f), false)).rgb, std::vector<std::uint8_t>(3, 128));
}

TEST(EncodePng, KeepsEveryPixel)
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 engine(seed);
        Picture picture = grey_picture(1 + int(engine() % 40), 1 + int(engine() % 40), 0);
        for (float& v : picture.rgb)
            v = float(engine() % 256) / 255.f;
        Decoded const decoded = decode(encode_png(picture, false));
        std::size_t const row = 3 * decoded.width;
        for (std::size_t i = 0; i < picture.rgb.size(); ++i)
            ASSERT_EQ(decoded.rgb[(decoded.height - 1 - i / row) * row + i % row], std::lround(255 * picture.rgb[i]))
                << "seed " << seed;
    }
}

TEST(Shrink, MakesMeansNoLongerThanAsked)
{
    Bitmap bitmap{4, 2, std::vector<std::uint8_t>(32, 100)};
    for (std::size_t i : {0u, 4u, 16u, 20u})
        bitmap.rgba[i] = static_cast<std::uint8_t>(10 * i);  // red of the left half: 0, 40, 160, 200
    Bitmap const small = shrink(bitmap, 2);
    EXPECT_EQ(small.width, 2u);
    EXPECT_EQ(small.height, 1u);
    EXPECT_EQ(small.rgba, (std::vector<std::uint8_t>{100, 100, 100, 100, 100, 100, 100, 100}));
}

TEST(Shrink, LeavesSmallAndThinOnesWhole)
{
    Bitmap const bitmap{3, 1, std::vector<std::uint8_t>(12, 7)};
    EXPECT_EQ(shrink(bitmap, 3).rgba, bitmap.rgba);
    EXPECT_EQ(shrink(bitmap, 1).height, 1u);
}

TEST(EncodePng, KeepsABitmap)
{
    Bitmap const bitmap{1, 2, {1, 2, 3, 255, 4, 5, 6, 255}};
    EXPECT_EQ(testat::decode_png(encode_png(bitmap)).rgba, bitmap.rgba);
}

TEST(EncodePng, IsTheSameBytesAgain)
{
    EXPECT_EQ(encode_png(grey_picture(9, 5, 0.3f), true), encode_png(grey_picture(9, 5, 0.3f), true));
}
}  // namespace testat
