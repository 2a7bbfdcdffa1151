#include "envelopes/envelope.h"

#include "grey_picture.h"
#include "process/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

namespace testat {
namespace {
/// One pixel, seen in these greys.
Envelope seen(std::size_t most_boxes, std::vector<float> const& values)
{
    EnvelopeBuilder builder(most_boxes);
    for (float v : values)
        builder.add(grey_picture(1, 1, v));
    return builder.finish(0);
}

bool outside(Envelope const& envelope, float r, float g, float b)
{
    float const rgb[] = {r, g, b};
    return envelope.is_outside(rgb, 0);
}

bool outside(Envelope const& envelope, float grey)
{
    return outside(envelope, grey, grey, grey);
}

Envelope two_pixels()
{
    EnvelopeBuilder builder(4);
    builder.add({2, 1, {0, 0, 0, 1, 1, 1}});
    builder.add({2, 1, {0, 0, 0, 0.5f, 1, 1}});
    return builder.finish(12.5);
}

class EnvelopeFile : public testing::Test {
protected:
    EnvelopeFile() { write_envelope(two_pixels(), file_); }
    TemporaryDirectory directory_;
    std::filesystem::path file_ = directory_.path() / "a.envelope";
};
}  // namespace

TEST(Envelope, HoldsWhatItHasSeen)
{
    Envelope const e = seen(1, {0.5f, 0.500001f});
    EXPECT_FALSE(outside(e, 0.5f));
    EXPECT_FALSE(outside(e, 0.500001f));
    EXPECT_TRUE(outside(e, 0.51f));
    EXPECT_TRUE(outside(e, 0.49f));
}

TEST(Envelope, LooksAtEveryChannel)
{
    Envelope const e = seen(1, {0.5f});
    EXPECT_TRUE(outside(e, 0.6f, 0.5f, 0.5f));
    EXPECT_TRUE(outside(e, 0.5f, 0.6f, 0.5f));
    EXPECT_TRUE(outside(e, 0.5f, 0.5f, 0.4f));
}

TEST(Envelope, HoldsNoNaNAndNoInfinity)
{
    Envelope const e = seen(4, {0.5f, 0.9f});
    EXPECT_TRUE(outside(e, NAN, 0.5f, 0.5f));
    EXPECT_TRUE(outside(e, 0.5f, 0.5f, NAN));
    EXPECT_TRUE(outside(e, HUGE_VALF));
    EXPECT_TRUE(outside(e, -HUGE_VALF));
}

TEST(Envelope, IsWidenedByHalfItsSizeAndAFewRoundings)
{
    // Margin of [0.5, 0.6]: 2e-6 + 0.05 + 0.6e-6.
    Envelope const e = seen(1, {0.5f, 0.6f});
    EXPECT_FALSE(outside(e, 0.650002f));
    EXPECT_TRUE(outside(e, 0.650004f));
    EXPECT_FALSE(outside(e, 0.449998f));
    EXPECT_TRUE(outside(e, 0.449996f));
}

TEST(Envelope, IsWidenedAroundASinglePoint)
{
    Envelope const e = seen(1, {1.f});
    EXPECT_FALSE(outside(e, 1.0000025f));
    EXPECT_TRUE(outside(e, 1.000004f));
}

TEST(Envelope, KeepsClustersApart)
{
    Envelope const e = seen(4, {0.f, 1.f, 0.00001f, 0.99999f});
    EXPECT_EQ(e.boxes.size(), 2u);
    EXPECT_FALSE(outside(e, 0.f));
    EXPECT_FALSE(outside(e, 1.f));
    EXPECT_TRUE(outside(e, 0.5f));
}

TEST(Envelope, IsOneBoxAroundMoreThanTwoTexels)
{
    Envelope const e = seen(4, {0, 0.2f, 0.4f, 0.6f, 0.62f, 1});
    EXPECT_EQ(e.boxes.size(), 1u);
    for (float v : {0.f, 0.2f, 0.3f, 0.4f, 0.6f, 0.62f, 1.f})
        EXPECT_FALSE(outside(e, v)) << v;
    EXPECT_TRUE(outside(e, 1.6f));
}

TEST(Envelope, HasOneBoxWhereTheFilterIsContinuous)
{
    Envelope const e = seen(1, {0, 1});
    EXPECT_EQ(e.boxes.size(), 1u);
    EXPECT_FALSE(outside(e, 0.5f));
}

TEST(Envelope, HoldsEveryRenderingItWasMadeOf)
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 engine(seed);
        std::vector<float> values(1 + engine() % 30);
        for (float& v : values)
            v = float(engine() % 7) + 1e-5f * float(engine() % 10);
        Envelope const e = seen(1 + seed % 4, values);
        for (float v : values)
            ASSERT_FALSE(outside(e, v)) << "seed " << seed;
    }
}

TEST(Envelope, ExpectsTheFirstRendering)
{
    EXPECT_EQ(seen(1, {0.25f, 0.5f}).expected.rgb, std::vector<float>(3, 0.25f));
}

TEST(Envelope, KeepsPixelsApart)
{
    Envelope const e = two_pixels();
    float const half[] = {0.5f, 1, 1};
    EXPECT_TRUE(e.is_outside(half, 0));
    EXPECT_FALSE(e.is_outside(half, 1));
    EXPECT_EQ(e.first, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(EnvelopeBuilder, WantsRenderingsOfOneSize)
{
    EnvelopeBuilder builder(1);
    builder.add(grey_picture(2, 2, 0));
    EXPECT_THROW(builder.add(grey_picture(2, 1, 0)), std::runtime_error);
}

TEST_F(EnvelopeFile, ComesBackAsItWas)
{
    Envelope const before = two_pixels();
    Envelope const after = read_envelope(file_);
    EXPECT_EQ(after.expected.width, 2);
    EXPECT_EQ(after.expected.height, 1);
    EXPECT_EQ(after.expected.rgb, before.expected.rgb);
    EXPECT_EQ(after.first, before.first);
    EXPECT_EQ(after.reference_ms, 12.5);
    ASSERT_EQ(after.boxes.size(), before.boxes.size());
    EXPECT_EQ(std::memcmp(after.boxes.data(), before.boxes.data(), before.boxes.size() * sizeof(Box)), 0);
}

TEST_F(EnvelopeFile, IsRefusedWhenCutShort)
{
    for (auto size = std::filesystem::file_size(file_); size-- > 0;) {
        std::filesystem::resize_file(file_, size);
        EXPECT_THROW(read_envelope(file_), std::runtime_error) << size;
    }
}

TEST_F(EnvelopeFile, IsRefusedIfItIsSomethingElse)
{
    std::ofstream(file_, std::ios::binary) << std::string(1000, 'x');
    EXPECT_THROW(read_envelope(file_), std::runtime_error);
}

TEST_F(EnvelopeFile, IsRefusedIfTheCountsDisagree)
{
    Envelope wrong = two_pixels();
    wrong.boxes.push_back(wrong.boxes[0]);
    write_envelope(wrong, file_);
    EXPECT_THROW(read_envelope(file_), std::runtime_error);
}

TEST_F(EnvelopeFile, IsRefusedIfItPointsOutside)
{
    Envelope wrong = two_pixels();
    wrong.first[1] = 1000;
    write_envelope(wrong, file_);
    EXPECT_THROW(read_envelope(file_), std::runtime_error);
}

TEST_F(EnvelopeFile, CannotBeWrittenWhereThereIsNoDirectory)
{
    EXPECT_THROW(write_envelope(two_pixels(), file_ / "below.envelope"), std::runtime_error);
    EXPECT_THROW(read_envelope(directory_.path() / "nothing.envelope"), std::runtime_error);
}
}  // namespace testat
