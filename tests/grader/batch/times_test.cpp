#include "batch/times.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <stdexcept>

namespace testat {
namespace {
/// The local time of the course, whatever the machine's is.
class Times : public testing::Test {
protected:
    Times()
    {
        setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);  // needs no data base of zones
        tzset();
    }
    ~Times() override
    {
        if (before_.empty())
            unsetenv("TZ");
        else
            setenv("TZ", before_.c_str(), 1);
        tzset();
    }

private:
    std::string before_ = std::getenv("TZ") == nullptr ? "" : std::getenv("TZ");
};

constexpr std::int64_t noon = 1'795'518'000;  // 2026-11-24T11:00:00Z
}  // namespace

TEST_F(Times, AreLocalWithoutAnOffset)
{
    EXPECT_EQ(parse_iso_time("2026-11-24T12:00"), noon);
    EXPECT_EQ(parse_iso_time("2026-11-24 12:00:00"), noon);
    EXPECT_EQ(parse_iso_time("2026-07-24T12:00"), parse_iso_time("2026-07-24T10:00Z"));
}

TEST_F(Times, HaveOffsets)
{
    for (char const* text :
         {"2026-11-24T11:00Z", "2026-11-24T12:00+01:00", "2026-11-24T12:00:00+0100", "2026-11-24T06:30-04:30"})
        EXPECT_EQ(parse_iso_time(text), noon) << text;
}

TEST_F(Times, OfADayAreItsEnd)
{
    EXPECT_EQ(parse_iso_time("2026-11-24"), noon + 12 * 3600 - 1);
}

TEST_F(Times, ThatDoNotExistAreNone)
{
    for (char const* text : {"", "tomorrow", "2026-13-01T00:00", "2026-02-30T00:00", "2026-11-24T24:00",
                             "2026-11-24T12:60", "2026-11-24T12:00+15:00", "2026-11-24T12", "24.11.2026"})
        EXPECT_FALSE(parse_iso_time(text)) << text;
}

TEST_F(Times, OfDeadlinesSayWhatIsUnderstood)
{
    EXPECT_EQ(parse_deadline("2026-11-24T12:00"), noon);
    try {
        parse_deadline("tomorrow");
        ADD_FAILURE();
    } catch (std::invalid_argument const& error) {
        EXPECT_NE(std::string(error.what()).find("2026-11-24T23:59"), std::string::npos);
    }
}

TEST_F(Times, OfCellsAreReadInAllWaysTheyAreWritten)
{
    for (char const* text : {"46350.5", "2026-11-24 12:00:00", "24.11.2026 12:00", "24.11.2026, 12:00:00",
                             "24. Nov 2026, 12:00", "24. November 2026, 12:00"})
        EXPECT_EQ(parse_cell_time(text), noon) << text;
    EXPECT_EQ(parse_cell_time("1. Mär 2026, 12:00"), parse_iso_time("2026-03-01T12:00"));
    EXPECT_EQ(parse_cell_time("1. Oct 2026, 12:00"), parse_iso_time("2026-10-01T12:00"));
}

TEST_F(Times, OfCellsAreNoOtherNumbers)
{
    for (char const* text : {"", "1.3", "12345", "99999", "nan", "uabcd", "24. Foo 2026, 12:00", "46350.5x"})
        EXPECT_FALSE(parse_cell_time(text)) << text;
}

TEST_F(Times, OfExcelAreRoundedToSeconds)
{
    EXPECT_EQ(parse_cell_time("46350.4999999"), noon);
}
}  // namespace testat
