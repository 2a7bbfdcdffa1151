#include "checks/matrices.h"
#include "checks/oracles.h"

#include <glm/gtc/matrix_transform.hpp>

namespace testat {
namespace {
constexpr int questions_each = 256;

struct Case {
    glm::dmat4 matrix;
    glm::dvec3 vector;
};

template <typename MakeCase>
auto ask(MakeCase const& make_case)
{
    return [=](Random& random, Textures const&) {
        std::vector<TransformQuestion> questions(questions_each);
        for (auto& q : questions) {
            Case const c = make_case(random);
            store(c.matrix, q.matrix);
            store(c.vector, q.vector);
        }
        return make_group(Kind::transform, questions);
    };
}

glm::dmat4 translation(Random& random)
{
    return glm::translate(glm::dmat4(1), random_vector(random, 10));
}

glm::dmat4 scaling(Random& random)
{
    return glm::scale(glm::dmat4(1), random_scale(random));
}

Case rotated_direction(Random& random)
{
    glm::dmat4 const rotation = random_rotation(random);
    return {rotation, random_direction(random)};
}

Case translated_direction(Random& random)
{
    glm::dmat4 const moved = translation(random) * random_rotation(random);
    return {moved, random_direction(random)};
}

Case scaled_direction(Random& random)
{
    glm::dmat4 const scaled = random_rotation(random) * scaling(random);
    double const length = std::exp2(random.uniform(-6, 6));
    return {scaled, random_direction(random) * length};
}

Case rigid_position(Random& random)
{
    glm::dmat4 const moved = translation(random) * random_rotation(random);
    return {moved, random_vector(random, 10)};
}

Case scaled_position(Random& random)
{
    glm::dmat4 const scaled = translation(random) * random_rotation(random) * scaling(random);
    return {scaled, random_vector(random, 10)};
}

/// Determinant below zero, axes no longer perpendicular.
Case mirrored_position(Random& random)
{
    glm::dmat4 shear(1);
    shear[1][0] = random.uniform(-1, 1);
    shear[2][1] = random.uniform(-1, 1);
    glm::dmat4 const mirror = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    glm::dmat4 const matrix = translation(random) * random_rotation(random) * shear * mirror;
    return {matrix, random_vector(random, 10)};
}

/// Matrix times (v, w), and for each component what at most six float roundings of its operands make; each of four
/// products may also lose half of the smallest float, 2^-149.
struct Product {
    glm::dvec3 value;
    glm::dvec3 error;
};

Product product(TransformQuestion const& q, double w)
{
    glm::dmat4 const m = dmat4(q.matrix);
    glm::dvec4 const v(dvec3(q.vector), w);
    glm::dmat4 magnitude;
    for (int i = 0; i < 4; ++i)
        magnitude[i] = glm::abs(m[i]);
    return {glm::dvec3(m * v), 6 * eps * glm::dvec3(magnitude * glm::abs(v)) + 0x1p-148};
}

Deviation compare_vector(Answers const& answers, std::uint32_t index, glm::dvec3 right, glm::dvec3 bound, Words words)
{
    auto const measured = floats<3>(answers, index);
    return compare({measured.begin(), measured.end()}, {right.x, right.y, right.z}, {bound.x, bound.y, bound.z}, words);
}
}  // namespace

/// Two vectors that differ by e have directions that differ by 2 |e| / |v| at most, however large e is; normalising
/// itself is four roundings.
Deviation direction_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    Product const p = product(question<TransformQuestion>(answers.group, index), 0);
    double const length = glm::length(p.value);
    glm::dvec3 const bound(2 * glm::length(p.error) / length + 4 * eps);
    return compare_vector(answers, index, p.value / length, bound, words);
}

Deviation position_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    Product const p = product(question<TransformQuestion>(answers.group, index), 1);
    return compare_vector(answers, index, p.value, p.error, words);
}

void add_transform_checks(std::vector<UnitCheck>& checks)
{
    auto const direction = [&](char const* name, auto make_case) {
        checks.push_back({std::string("TransformDirection.") + name, Function::transform_direction, ask(make_case),
                          judge_by(direction_deviation)});
    };
    direction("Rotations", rotated_direction);
    direction("TranslationIsIgnored", translated_direction);
    direction("LengthIsOne", scaled_direction);
    auto const position = [&](char const* name, auto make_case) {
        checks.push_back({std::string("TransformPosition.") + name, Function::transform_position, ask(make_case),
                          judge_by(position_deviation)});
    };
    position("RigidMotions", rigid_position);
    position("NonUniformScale", scaled_position);
    position("MirroredAndSheared", mirrored_position);
}
}  // namespace testat
