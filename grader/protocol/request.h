#pragma once
#include "functions.h"
#include "protocol/questions.h"

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/// What travels between judge and probe. Judge to probe: one Request, serialised. Probe to judge: a Greeting, then for
/// each group of the request in order a GroupStatus and the group's answer words.
namespace testat {
/// A texture as the judge made it: level 0 first, RGBA floats, row 0 at the bottom.
struct TextureData {
    struct Level {
        std::int32_t width = 0;
        std::int32_t height = 0;
        std::vector<float> texels;  ///< width * height * 4
    };
    std::uint32_t wrap_mode = 0;  ///< TextureWrapMode of the framework
    std::vector<Level> levels;
};

/// Questions of one kind to one arrangement of functions, answered in a child process of their own.
struct Group {
    std::string name;         ///< "EvaluateNearest.NegativeCoordinates", "isolated/plane_after_c", ...
    FunctionSet from_upload;  ///< the rest comes from the reference
    Function under_test{};    ///< which function a lookup, wrap or transform question calls
    Kind kind = Kind::wrap;
    std::uint32_t count = 0;
    std::uint32_t words_per_answer = 0;
    bool culling = true;  ///< of a picture: objects that a ray cannot meet may be left out
    /// What memory holds that nobody has written to yet, 1 to 255; 0 leaves it as it happens to be. A function that
    /// gives other answers with another fill reads memory before it is written.
    std::uint32_t fill = 0;
    bool twice = false;  ///< all questions are asked once more: see GroupStatus::kept
    /// So many times, up to `most_passes`, all questions are asked once more to see how long they take: see
    /// GroupStatus::pass_s.
    std::uint32_t passes = 0;
    std::vector<std::byte> questions;  ///< count * question_bytes(kind)

    std::size_t answer_size() const { return std::size_t(count) * words_per_answer; }  ///< in words
};

constexpr std::uint32_t most_passes = 100;

/// CPU seconds; wall limits of groups are derived from them.
struct Limits {
    double group_s = 10;         ///< for a group of questions
    double after_timeout_s = 1;  ///< for a group whose functions have run into the limit before
    double total_s = 20;         ///< for all groups with the same functions
    double hanging_s = 3;        ///< for all groups with functions that have run into the limit before, from then on
    double all_s = 60;           ///< for the whole request
    double wall_s = 90;          ///< for the whole request, by the clock on the wall
};

struct Request {
    Limits limits;
    FunctionSet hanging;  ///< have run into the limit before, in another request
    std::vector<TextureData> textures;
    std::vector<Group> groups;
};

/// How a group's child ended.
enum class Ended : std::uint32_t { answered, signal, exit, exception, timed_out, not_loaded, lost, count };

/// What the probe's server says of a group. Texts come from the upload: hostile bytes, not always terminated.
struct GroupStatus {
    Ended ended = Ended::lost;
    std::int32_t code = 0;       ///< signal number or exit status
    std::uint32_t answered = 0;  ///< questions finished; the one that failed is this index
    std::uint32_t printed = 0;   ///< bytes written to stdout and stderr, as far as they were kept
    std::uint32_t wrote = 0;     ///< not 0 if static or global variables of the upload have changed, as the child says
    double cpu_s = 0;            ///< of the child, all of it
    double work_s = 0;           ///< of answering only, as the child says it
    /// Of a group that is asked twice: bytes on the heap that the second time has left behind, as the child says it.
    double kept = 0;
    /// CPU time of the fastest of a group's passes, as the child says it; 0 if nobody knows.
    double pass_s = 0;
    char text[256] = {};    ///< what() of an exception, or the loader's complaint
    char output[256] = {};  ///< the beginning of what was printed
};
static_assert(std::is_trivially_copyable_v<GroupStatus>);

constexpr std::uint32_t greeting = 0x74737431;  ///< first word of an answer stream: the probe is alive

/// An answer word that was never written: a quiet NaN as float, an impossible index as integer.
constexpr std::uint32_t unanswered = 0x7fc0dead;

/// With other limits than the request's own.
std::vector<std::byte> serialize(Request const& request, Limits const& limits);

inline std::vector<std::byte> serialize(Request const& request)
{
    return serialize(request, request.limits);
}

/// The inverse. Throws std::runtime_error when the bytes are not one whole request.
Request parse_request(std::vector<std::byte> const& bytes);
}  // namespace testat
