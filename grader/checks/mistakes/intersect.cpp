#include "checks/mistakes/mistake.h"
#include "checks/shapes.h"

namespace testat {
namespace {
/// Which of the object's matrices is used.
enum class Matrix { none, object_to_world, world_to_object };
/// How t is found: along the ray that meets the shape, from the hit that is returned, or as it should be.
enum class Distance { of_object_ray, to_result, in_world };

struct Rule {
    Matrix ray = Matrix::world_to_object;
    Matrix position = Matrix::object_to_world;
    Matrix normal = Matrix::world_to_object;  ///< transposed, as normals need it
    bool transpose_for_normal = true;
    Distance distance = Distance::in_world;
};

struct WrongHit {
    double t;
    glm::dvec3 position;
    glm::dvec3 normal;
};

glm::dmat4 choose(Matrix which, glm::dmat4 const& to_world)
{
    return which == Matrix::none ? glm::dmat4(1) : which == Matrix::object_to_world ? to_world : glm::inverse(to_world);
}

glm::dvec3 transform(glm::dmat4 const& matrix, glm::dvec3 v, double w)
{
    return glm::dvec3(matrix * glm::dvec4(v, w));
}

std::optional<WrongHit> meet_wrongly(IntersectQuestion const& q, Rule const& rule)
{
    glm::dmat4 const to_world = dmat4(q.object_to_world);
    glm::dmat4 const of_ray = choose(rule.ray, to_world);
    glm::dvec3 const origin = dvec3(q.origin);
    auto const met = meet(q.shape, {transform(of_ray, origin, 1),
                                    glm::normalize(transform(of_ray, glm::normalize(dvec3(q.direction)), 0))});
    if (!met)
        return std::nullopt;
    glm::dmat4 const of_normal = choose(rule.normal, to_world);
    WrongHit hit{met->t, transform(choose(rule.position, to_world), met->position, 1), {}};
    glm::dmat3 const linear(of_normal);
    hit.normal = glm::normalize((rule.transpose_for_normal ? glm::transpose(linear) : linear) * met->normal);
    if (rule.distance == Distance::to_result)
        hit.t = glm::length(hit.position - origin);
    if (rule.distance == Distance::in_world)
        hit.t = glm::length(transform(to_world, met->position, 1) - origin);
    return hit;
}

/// Far looser than the checks, and still no accident for hundreds of answers.
bool is_close(double difference, double size)
{
    return difference <= 1e-3 * (1 + size);
}

bool explains(Answers const& answers, std::uint32_t i, std::optional<WrongHit> const& wrong, double reach)
{
    if ((integer(answers, i) != 0) != wrong.has_value())
        return false;
    if (!wrong)
        return true;
    auto const part = [&](std::size_t word) { return dvec3(floats<3>(answers, i, word).data()); };
    return is_close(std::abs(floats<1>(answers, i, 1)[0] - wrong->t), reach) &&
           is_close(glm::length(part(2) - wrong->position), reach) &&
           is_close(glm::length(part(5) - wrong->normal), 1) && is_close(glm::length(part(8) - wrong->normal), 1);
}

/// Without transforms everything is right.
constexpr Rule untransformed{Matrix::none, Matrix::none, Matrix::none, true, Distance::of_object_ray};

Model model(Rule const& rule)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const&) {
                auto const q = question<IntersectQuestion>(answers.group, i);
                auto const wrong = meet_wrongly(q, q.transform_objects != 0 ? rule : untransformed);
                double const reach = glm::length(dvec3(q.origin)) + (wrong ? glm::length(wrong->position) : 0);
                return explains(answers, i, wrong, reach);
            },
            nullptr};
}
}  // namespace

void add_intersect_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Rule> const& rules) {
        Mistake mistake{id, Function::intersect, {}};
        for (auto const& rule : rules)
            mistake.models.push_back(model(rule));
        mistakes.push_back(std::move(mistake));
    };
    constexpr auto none = Matrix::none;
    constexpr auto to_world = Matrix::object_to_world;
    constexpr auto to_object = Matrix::world_to_object;
    add("intersect_leaves_t_in_object_space", {{to_object, to_world, to_object, true, Distance::of_object_ray}});
    add("intersect_not_transformed_back",
        {{to_object, none, none, true, Distance::in_world}, {to_object, none, none, true, Distance::to_result}});
    add("intersect_t_not_transformed_and_not_back", {{to_object, none, none, true, Distance::of_object_ray}});
    add("intersect_normals_by_object_to_world", {{to_object, to_world, to_world, false, Distance::in_world}});
    add("intersect_normals_by_world_to_object", {{to_object, to_world, to_object, false, Distance::in_world}});
    std::vector<Rule> untouched_ray, wrong_way;
    for (auto const distance : {Distance::of_object_ray, Distance::to_result}) {
        untouched_ray.push_back({none, none, none, true, distance});
        untouched_ray.push_back({none, to_world, to_object, true, distance});
        wrong_way.push_back({to_world, to_world, to_object, true, distance});
        wrong_way.push_back({to_world, to_object, to_world, true, distance});
        wrong_way.push_back({to_world, to_object, to_object, true, distance});
        wrong_way.push_back({to_world, none, none, true, distance});
    }
    add("intersect_ray_not_transformed", untouched_ray);
    add("intersect_transforms_ray_with_object_to_world", wrong_way);
}
}  // namespace testat
