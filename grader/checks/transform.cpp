#include "checks/matrices.h"
#include "checks/oracles.h"
#include "checks/relations.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace testat {
namespace {
constexpr int questions_each = 256;

struct Case {
    glm::dmat4 matrix;
    glm::dvec3 vector;
};

TransformQuestion make_question(Case const& c)
{
    TransformQuestion q{};
    store(c.matrix, q.matrix);
    store(c.vector, q.vector);
    return q;
}

template <typename MakeCase>
auto ask(MakeCase const& make_case)
{
    return [=](Random& random, Textures const&) {
        std::vector<TransformQuestion> questions;
        for (int i = 0; i < questions_each; ++i)
            questions.push_back(make_question(make_case(random)));
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

/// Every other matrix mirrors.
glm::dmat4 mirroring(Random& random)
{
    return glm::scale(glm::dmat4(1), glm::dvec3(random.coin() ? -1 : 1, 1, 1));
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

/// Now and then with a matrix that changes nothing.
Case scaled_direction(Random& random)
{
    glm::dmat4 const mirror = mirroring(random);
    glm::dmat4 const scaled = random_rotation(random) * scaling(random) * mirror;
    double const length = std::exp2(random.uniform(-6, 6));
    return {random.integer(0, 15) == 0 ? glm::dmat4(1) : scaled, random_direction(random) * length};
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

/// f(R M Q, Q^-1 d) = R f(M, d) for rotations.
struct RotatedMatrix {
    std::array<TransformQuestion, 2> questions;
    glm::dmat3 rotation;  ///< R
    double bound;
};

RotatedMatrix rotate_matrix(Random& random, Textures const&)
{
    Case const c = rotated_direction(random);
    glm::dmat4 const left = random_rotation(random);
    glm::dmat4 const right = random_rotation(random);
    glm::dvec3 const turned = glm::transpose(glm::dmat3(right)) * c.vector;
    RotatedMatrix relation{
        {make_question(c), make_question({left * c.matrix * right, turned})}, glm::dmat3(left), 8 * eps};
    for (auto const& q :
         relation.questions)  // the answer as direction_deviation says, and the question is rounded, too
        relation.bound += 3 * glm::length(product(q, 0).error);
    return relation;
}

glm::dvec3 measured_vector(Answers const& answers, std::uint32_t place)
{
    return dvec3(floats<3>(answers, place).data());
}

Deviation compare_rotated(Answers const& answers, RotatedMatrix const& relation,
                          std::array<std::uint32_t, 2> const& places)
{
    glm::dvec3 const before = measured_vector(answers, places[0]);
    glm::dvec3 const after = measured_vector(answers, places[1]);
    glm::dvec3 const right = relation.rotation * before;
    Deviation d =
        compare({after.x, after.y, after.z}, {right.x, right.y, right.z}, std::vector<double>(3, relation.bound));
    d.measured =
        fmt::format("f(M, d) = {}, f(R M Q, Q^-1 d) = {}", format_vector({before.x, before.y, before.z}), d.measured);
    d.expected = "f(R M Q, Q^-1 d) = R f(M, d) = " + d.expected;
    return d;
}

/// f(A M B, B^-1 (p + q - r)) = A (f(M, p) + f(M, q) - f(M, r)) for rigid motions.
struct MovedMatrix {
    std::array<TransformQuestion, 4> questions;
    glm::dmat4 motion;  ///< A
    double bound;
};

glm::dmat4 rigid_motion(Random& random)
{
    glm::dmat4 const rotation = random_rotation(random);
    return translation(random) * rotation;
}

MovedMatrix move_matrix(Random& random, Textures const&)
{
    glm::dmat4 const matrix = rigid_motion(random);
    glm::dmat4 const left = rigid_motion(random);
    glm::dmat4 const right = rigid_motion(random);
    glm::dvec3 const p = random_vector(random, 10);
    glm::dvec3 const q = random_vector(random, 10);
    glm::dvec3 const r = random_vector(random, 10);
    glm::dvec3 const moved(glm::inverse(right) * glm::dvec4(p + q - r, 1));
    MovedMatrix relation{{make_question({matrix, p}), make_question({matrix, q}), make_question({matrix, r}),
                          make_question({left * matrix * right, moved})},
                         left,
                         0};
    for (auto const& question : relation.questions)  // once for the answer, once because the question is rounded
        relation.bound += 2 * glm::length(product(question, 1).error);
    return relation;
}

Deviation compare_moved(Answers const& answers, MovedMatrix const& relation, std::array<std::uint32_t, 4> const& places)
{
    auto const f = [&](std::size_t i) { return measured_vector(answers, places[i]); };
    glm::dvec3 const right(relation.motion * glm::dvec4(f(0) + f(1) - f(2), 1));
    glm::dvec3 const last = f(3);
    Deviation d =
        compare({last.x, last.y, last.z}, {right.x, right.y, right.z}, std::vector<double>(3, relation.bound));
    d.measured = "f(A M B, B^-1 (p + q - r)) = " + d.measured;
    d.expected = "A (f(M, p) + f(M, q) - f(M, r)) = " + d.expected;
    return d;
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
    checks.push_back(metamorphic_check("TransformDirection.RotatedMatrix", Function::transform_direction,
                                       Kind::transform, rotate_matrix, compare_rotated));
    auto const position = [&](char const* name, auto make_case) {
        checks.push_back({std::string("TransformPosition.") + name, Function::transform_position, ask(make_case),
                          judge_by(position_deviation)});
    };
    position("RigidMotions", rigid_position);
    position("NonUniformScale", scaled_position);
    position("MirroredAndSheared", mirrored_position);
    checks.push_back(metamorphic_check("TransformPosition.MovedMatrix", Function::transform_position, Kind::transform,
                                       move_matrix, compare_moved));
}
}  // namespace testat
