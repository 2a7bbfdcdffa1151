#include "checks/matrices.h"
#include "checks/oracles.h"
#include "checks/relations.h"

#include <fmt/format.h>

namespace testat {
namespace {
constexpr int questions_each = 256;

/// A right-handed frame: bitangent = tangent x normal.
TangentSpaceQuestion make_question(glm::dmat3 const& frame, glm::dvec3 d)
{
    TangentSpaceQuestion q{};
    store(d, q.d);
    store(frame[0], q.tangent);
    store(frame[1], q.normal);
    store(frame[2], q.bitangent);
    return q;
}

TangentSpaceQuestion random_frame(Random& random, double length)
{
    glm::dmat3 const rotation(random_rotation(random));
    return make_question(rotation, random_direction(random) * length);
}

Group ask_unit(Random& random, Textures const&)
{
    std::vector<TangentSpaceQuestion> questions;
    for (int i = 0; i < questions_each; ++i)
        questions.push_back(random_frame(random, 1));
    return make_group(Kind::tangent_space, questions);
}

/// The first six exactly along the axes of the frame.
Group ask_lengths(Random& random, Textures const&)
{
    std::vector<TangentSpaceQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        double const longer = std::exp2(random.uniform(0.5, 6));
        double const length = random.coin() ? longer : 1 / longer;
        questions.push_back(random_frame(random, length));
        if (i < 6) {
            glm::dvec3 d(0);
            d[i / 2] = i % 2 == 0 ? length : -length;
            store(d, questions.back().d);
        }
    }
    return make_group(Kind::tangent_space, questions);
}

/// f(Q^-1 d, R F Q) = R f(d, F) for a frame F and rotations.
struct RotatedFrame {
    std::array<TangentSpaceQuestion, 2> questions;
    glm::dmat3 rotation;  ///< R
};

RotatedFrame rotate_frame(Random& random, Textures const&)
{
    glm::dmat3 const frame(random_rotation(random));
    glm::dmat3 const left(random_rotation(random));
    glm::dmat3 const right(random_rotation(random));
    glm::dvec3 const d = random_direction(random);
    return {{make_question(frame, d), make_question(left * frame * right, glm::transpose(right) * d)}, left};
}

/// Both answers may be off as tangent_space_deviation says, and the questions of both are rounded.
Deviation compare_rotated(Answers const& answers, RotatedFrame const& relation,
                          std::array<std::uint32_t, 2> const& places)
{
    glm::dvec3 const before = dvec3(floats<3>(answers, places[0]).data());
    glm::dvec3 const right = relation.rotation * before;
    auto const after = floats<3>(answers, places[1]);
    Deviation d = compare({after.begin(), after.end()}, {right.x, right.y, right.z}, std::vector<double>(3, 64 * eps));
    d.measured =
        fmt::format("f(d, F) = {}, f(Q^-1 d, R F Q) = {}", format_vector({before.x, before.y, before.z}), d.measured);
    d.expected = "f(Q^-1 d, R F Q) = R f(d, F) = " + d.expected;
    return d;
}
}  // namespace

/// Three products and two sums make five roundings of the operands at most, normalising makes four more. Where the
/// axes are not perpendicular the sum may cancel; then the error counts as it does for transform_direction.
Deviation tangent_space_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    auto const q = question<TangentSpaceQuestion>(answers.group, index);
    glm::dmat3 const axes(dvec3(q.tangent), dvec3(q.normal), dvec3(q.bitangent));
    glm::dmat3 const magnitude(glm::abs(axes[0]), glm::abs(axes[1]), glm::abs(axes[2]));
    glm::dvec3 const d = dvec3(q.d);
    glm::dvec3 const sum = axes * d;
    double const length = glm::length(sum);
    double const error = 5 * eps * glm::length(magnitude * glm::abs(d)) + 0x1p-148;
    glm::dvec3 const right = sum / length;
    auto const measured = floats<3>(answers, index);
    return compare({measured.begin(), measured.end()}, {right.x, right.y, right.z},
                   std::vector<double>(3, 2 * error / length + 4 * eps), words);
}

void add_tangent_space_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto ask) {
        checks.push_back({std::string("TangentSpace.") + name, Function::transform_direction_to_object_space, ask,
                          judge_by(tangent_space_deviation)});
    };
    add("OrthonormalFrames", ask_unit);
    add("LengthIsOne", ask_lengths);
    checks.push_back(metamorphic_check("TangentSpace.RotatedFrame", Function::transform_direction_to_object_space,
                                       Kind::tangent_space, rotate_frame, compare_rotated));
}
}  // namespace testat
