#include "checks/mistakes/mistake.h"
#include "checks/vectors.h"

#include <glm/gtc/matrix_inverse.hpp>

namespace testat {
namespace {
/// The vector that a wrong solution gives.
using WrongVector = std::function<glm::dvec3(glm::dmat4 const&, glm::dvec3)>;

/// Far looser than the checks, and still no accident for hundreds of answers.
bool is_close(glm::dvec3 measured, glm::dvec3 expected)
{
    return glm::length(measured - expected) <= 1e-4 * (1 + glm::length(expected));
}

Model transform_model(WrongVector const& wrong)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const&) {
                auto const q = question<TransformQuestion>(answers.group, i);
                return is_close(dvec3(floats<3>(answers, i).data()), wrong(dmat4(q.matrix), dvec3(q.vector)));
            },
            nullptr};
}

/// The matrix times (v, w), after `change`.
template <typename Change>
WrongVector product(Change const& change, double w, bool normalised)
{
    return [=](glm::dmat4 const& m, glm::dvec3 v) {
        glm::dvec3 const result(change(m) * glm::dvec4(v, w));
        return normalised ? glm::normalize(result) : result;
    };
}

glm::dmat4 as_it_is(glm::dmat4 const& m)
{
    return m;
}

glm::dmat4 transposed(glm::dmat4 const& m)
{
    return glm::transpose(m);
}

glm::dmat4 inverted(glm::dmat4 const& m)
{
    return glm::inverse(m);
}

glm::dmat4 for_normals(glm::dmat4 const& m)
{
    return glm::dmat4(glm::transpose(glm::inverse(glm::dmat3(m))));
}

/// The same by cross products of the columns: a mirror turns it round.
glm::dmat4 for_normals_unscaled(glm::dmat4 const& m)
{
    return for_normals(m) * glm::determinant(glm::dmat3(m));
}

/// d in a frame of these three axes, the first one for d.x.
using Axes = glm::dmat3 (*)(glm::dvec3 tangent, glm::dvec3 normal, glm::dvec3 bitangent);

Model tangent_space_model(Axes axes, bool normalised)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const&) {
                auto const q = question<TangentSpaceQuestion>(answers.group, i);
                glm::dvec3 const sum = axes(dvec3(q.tangent), dvec3(q.normal), dvec3(q.bitangent)) * dvec3(q.d);
                return is_close(dvec3(floats<3>(answers, i).data()), normalised ? glm::normalize(sum) : sum);
            },
            nullptr};
}

using Vector = glm::dvec3;
constexpr Axes wrong_orders[] = {
    [](Vector t, Vector n, Vector b) { return glm::dmat3(t, b, n); },
    [](Vector t, Vector n, Vector b) { return glm::dmat3(n, t, b); },
    [](Vector t, Vector n, Vector b) { return glm::dmat3(n, b, t); },
    [](Vector t, Vector n, Vector b) { return glm::dmat3(b, t, n); },
    [](Vector t, Vector n, Vector b) { return glm::dmat3(b, n, t); },
};

glm::dmat3 right_order(Vector t, Vector n, Vector b)
{
    return {t, n, b};
}

glm::dmat3 other_way(Vector t, Vector n, Vector b)
{
    return glm::transpose(glm::dmat3(t, n, b));
}
}  // namespace

void add_transform_mistakes(std::vector<Mistake>& mistakes)
{
    auto const direction = [&](char const* id, std::vector<WrongVector> const& wrong) {
        mistakes.push_back({id, Function::transform_direction, {}});
        for (auto const& w : wrong)
            mistakes.back().models.push_back(transform_model(w));
    };
    direction("direction_not_normalised", {product(as_it_is, 0, false)});
    direction("direction_is_translated", {product(as_it_is, 1, true), product(as_it_is, 1, false)});
    direction("direction_by_transposed_matrix", {product(transposed, 0, true), product(transposed, 0, false)});
    direction("direction_by_inverse_matrix", {product(inverted, 0, true), product(inverted, 0, false)});
    direction("direction_as_normal", {product(for_normals, 0, true), product(for_normals_unscaled, 0, true)});
    auto const position = [&](char const* id, std::vector<WrongVector> const& wrong) {
        mistakes.push_back({id, Function::transform_position, {}});
        for (auto const& w : wrong)
            mistakes.back().models.push_back(transform_model(w));
    };
    position("position_normalised", {product(as_it_is, 1, true)});
    position("position_not_translated", {product(as_it_is, 0, false), product(as_it_is, 0, true)});
    position("position_by_transposed_matrix", {product(transposed, 1, false)});
    position("position_by_inverse_matrix", {product(inverted, 1, false)});
}

void add_tangent_space_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Model> const& models) {
        mistakes.push_back({id, Function::transform_direction_to_object_space, models});
    };
    std::vector<Model> orders;
    for (Axes const axes : wrong_orders)
        orders.push_back(tangent_space_model(axes, true));
    add("tangent_axes_in_wrong_order", orders);
    add("tangent_inverse_rotation", {tangent_space_model(other_way, true)});
    add("tangent_not_normalised", {tangent_space_model(right_order, false)});
}
}  // namespace testat
