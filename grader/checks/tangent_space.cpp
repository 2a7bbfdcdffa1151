#include "checks/check.h"
#include "checks/matrices.h"

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

/// Three products, two sums and the normalisation, in units of the length.
Verdict judge(Answers const& answers, Textures const&)
{
    return judge_each<TangentSpaceQuestion>(answers, [&](TangentSpaceQuestion const& q, std::uint32_t i) {
        glm::dvec3 const d = dvec3(q.d);
        glm::dvec3 const sum = d.x * dvec3(q.tangent) + d.y * dvec3(q.normal) + d.z * dvec3(q.bitangent);
        glm::dvec3 const right = glm::normalize(sum);
        auto const measured = floats<3>(answers, i);
        return compare({measured.begin(), measured.end()}, {right.x, right.y, right.z},
                       std::vector<double>(3, 24 * eps));
    });
}
}  // namespace

void add_tangent_space_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto ask) {
        checks.push_back(
            {std::string("TangentSpace.") + name, Function::transform_direction_to_object_space, ask, judge});
    };
    add("OrthonormalFrames", ask_unit);
    add("LengthIsOne", ask_lengths);
}
}  // namespace testat
