// A stream of answers that somebody has damaged on its way: no crash, no hang, and no point that it did not earn
// before.
#include "checks/check.h"
#include "observe/observe.h"
#include "reference_answers.h"
#include "sanitizers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

namespace testat {
namespace {
using Bytes = std::vector<std::byte>;
using Names = std::set<std::string>;

/// Every second check answered as the reference does, the others by zeros, as the probe would send it.
struct Stream {
    Stream()
    {
        append(&greeting, sizeof greeting);
        for (std::size_t i = 0; i < unit_checks().size(); ++i) {
            Group const group = questions_of(unit_checks()[i], 1, textures);
            Answers const answers = i % 2 == 0 ? reference_answers(group, textures) : constant_answers(group, 0);
            append(&answers.status, sizeof answers.status);
            append(answers.words.data(), 4 * answers.words.size());
            request.groups.push_back(group);
        }
    }

    void append(void const* data, std::size_t size)
    {
        auto const* begin = static_cast<std::byte const*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
    }

    Textures textures = make_test_textures(1);
    Request request;
    Bytes bytes;
};

/// The checks with points that the answers pass. Relations have none: they only take away what a table of answers
/// earns.
Names passed(Stream const& stream, Bytes const& bytes)
{
    Names names;
    Observations const observations = decode_answers(stream.request, bytes);
    for (auto const& check : unit_checks())
        if (!check.is_metamorphic && check.judge(observations.groups.at(check.name), stream.textures).passed())
            names.insert(check.name);
    return names;
}

class Vandal {
public:
    explicit Vandal(unsigned seed) : random_(seed) {}

    void damage(Bytes& bytes)
    {
        int const times = 1 << below(10);
        switch (below(5)) {
            case 0:  // bits
                for (int i = 0; i < times; ++i)
                    bytes[below(bytes.size())] ^= std::byte(1 << below(8));
                break;
            case 1:  // words: large, small, not a number
                for (int i = 0; i < times; ++i)
                    put_word(bytes);
                break;
            case 2:  // too short
                bytes.resize(below(bytes.size()));
                break;
            case 3:  // shifted
                bytes.insert(bytes.begin() + std::ptrdiff_t(below(bytes.size())), below(64), std::byte(below(256)));
                break;
            default:  // one part in the place of another
                copy_part(bytes);
        }
    }

private:
    std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }

    void put_word(Bytes& bytes)
    {
        static std::uint32_t const words[] = {0,          1,          0xffffffff, 0x7fc00000,
                                              0x7f800000, 0xff800000, 0x80000000, 0x3f800000};
        std::uint32_t const word = below(2) == 0 ? words[below(std::size(words))] : std::uint32_t(random_());
        std::memcpy(&bytes[4 * below(bytes.size() / 4)], &word, sizeof word);
    }

    void copy_part(Bytes& bytes)
    {
        std::size_t const size = below(bytes.size() / 2);
        std::size_t const from = below(bytes.size() - size);
        std::size_t const to = below(bytes.size() - size);
        std::memmove(&bytes[to], &bytes[from], size);
    }

    std::mt19937 random_;
};
}  // namespace

TEST(CorruptedAnswers, EarnNothingNew)
{
    Stream const stream;
    Names const earned = passed(stream, stream.bytes);
    EXPECT_GE(earned.size(), unit_checks().size() / 4);
    EXPECT_LT(earned.size(), unit_checks().size());
    constexpr unsigned corruptions = is_sanitized ? 100 : 1000;  // ten times as slow there
    for (unsigned seed = 1; seed <= corruptions; ++seed) {
        Bytes bytes = stream.bytes;
        Vandal(seed).damage(bytes);
        try {
            Names const now = passed(stream, bytes);
            for (auto const& name : now)
                EXPECT_EQ(earned.count(name), 1u) << name << ", seed " << seed;
        } catch (std::runtime_error const& e) {
            EXPECT_STREQ(e.what(), "the probe did not start") << "seed " << seed;
        }
    }
}
}  // namespace testat
