#include "checks/matrices.h"
#include "checks/oracles.h"

namespace testat {
namespace {
constexpr int questions_each = 256;

/// A right-handed frame: bitangent = tangent x normal.
TangentSpaceQuestion random_frame(Random& random, double length)
{
    glm::dmat3 const rotation(random_rotation(random));
    TangentSpaceQuestion q{};
    store(random_direction(random) * length, q.d);
    store(rotation[0], q.tangent);
    store(rotation[1], q.normal);
    store(rotation[2], q.bitangent);
    return q;
}

Group ask_unit(Random& random, Textures const&)
{
    std::vector<TangentSpaceQuestion> questions;
    for (int i = 0; i < questions_each; ++i)
        questions.push_back(random_frame(random, 1));
    return make_group(Kind::tangent_space, questions);
}

Group ask_lengths(Random& random, Textures const&)
{
    std::vector<TangentSpaceQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        double const length = std::exp2(random.uniform(0.5, 6));
        questions.push_back(random_frame(random, random.coin() ? length : 1 / length));
    }
    return make_group(Kind::tangent_space, questions);
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
}
}  // namespace testat
