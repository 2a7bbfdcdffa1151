#include "checks/footprint.h"
#include "checks/mistakes/mistake.h"

namespace testat {
namespace {
enum class Plane { tangent, object };
enum class Miss { stays, origin };

/// Where the corners' rays meet a plane.
struct Corners {
    glm::dvec3 positions[4];
    Corner uvs[4];
};

Corners corners(FootprintQuestion const& q, Plane plane, Miss miss)
{
    Corners found;
    glm::dvec3 const normal = dvec3(plane == Plane::tangent ? q.normal : q.shape.a);
    for (int i = 0; i < 4; ++i) {
        Line const ray{dvec3(q.origin[i]), glm::normalize(dvec3(q.direction[i]))};
        auto const t = meet_plane(dvec3(q.position), normal, ray);
        glm::dvec3 const otherwise = miss == Miss::stays ? dvec3(q.position) : glm::dvec3(0);
        found.positions[i] = t ? ray.origin + *t * ray.direction : otherwise;
        found.uvs[i] = map_corner(q, found.positions[i], 0);
    }
    mend_seams(found.uvs);
    return found;
}

/// The size that a wrong solution gives.
using WrongSize = std::function<glm::dvec2(FootprintQuestion const&)>;

/// Far looser than the check, and still no accident for hundreds of answers.
Model model(WrongSize const& wrong)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const&) {
                auto const q = question<FootprintQuestion>(answers.group, i);
                glm::dvec2 const expected = wrong(q);
                auto const measured = floats<2>(answers, i);
                double const reach = glm::length(dvec2(q.uv)) + glm::length(expected) + 1;
                return std::abs(measured[0] - expected.x) <= 1e-4 * reach &&
                       std::abs(measured[1] - expected.y) <= 1e-4 * reach;
            },
            nullptr};
}

/// Size of the box around those corners whose bits are set.
glm::dvec2 box(Corners const& c, unsigned which)
{
    glm::dvec2 lower(HUGE_VAL), upper(-HUGE_VAL);
    for (unsigned i = 0; i < 4; ++i)
        if ((which >> i & 1u) != 0) {
            lower = glm::min(lower, c.uvs[i].offset);
            upper = glm::max(upper, c.uvs[i].offset);
        }
    return upper - lower;
}

Model box_of(unsigned which)
{
    return model([=](FootprintQuestion const& q) { return box(corners(q, Plane::tangent, Miss::stays), which); });
}

Model scaled(double factor)
{
    return model([=](FootprintQuestion const& q) { return factor * box(corners(q, Plane::tangent, Miss::stays), 15); });
}

/// Corners of the box in space instead of in uv; `x` and `y` are the axes that are taken for u and v.
Model box_of_positions(int x, int y)
{
    return model([=](FootprintQuestion const& q) {
        Corners const c = corners(q, Plane::tangent, Miss::stays);
        glm::dvec3 lower = c.positions[0], upper = c.positions[0];
        for (auto const& p : c.positions) {
            lower = glm::min(lower, p);
            upper = glm::max(upper, p);
        }
        return glm::dvec2(upper[x] - lower[x], upper[y] - lower[y]);
    });
}

glm::dvec2 from_the_first(FootprintQuestion const& q)
{
    Corners const c = corners(q, Plane::tangent, Miss::stays);
    glm::dvec2 most(0);
    for (auto const& uv : c.uvs)
        most = glm::max(most, glm::abs(uv.offset - c.uvs[0].offset));
    return most;
}

glm::dvec2 from_one_to_the_next(FootprintQuestion const& q)
{
    Corners const c = corners(q, Plane::tangent, Miss::stays);
    glm::dvec2 most(0);
    for (int i = 0; i < 3; ++i)
        most = glm::max(most, glm::abs(c.uvs[i + 1].offset - c.uvs[i].offset));
    return most;
}

/// The farthest corner from the intersection.
glm::dvec2 from_the_middle(FootprintQuestion const& q)
{
    Corners const c = corners(q, Plane::tangent, Miss::stays);
    glm::dvec2 most(0);
    for (auto const& uv : c.uvs)
        most = glm::max(most, glm::abs(uv.offset));
    return most;
}

glm::dvec2 around_zero(FootprintQuestion const& q)
{
    Corners const c = corners(q, Plane::tangent, Miss::stays);
    glm::dvec2 lower(0), upper(0);
    for (auto const& corner : c.uvs) {
        lower = glm::min(lower, corner.offset + dvec2(q.uv));
        upper = glm::max(upper, corner.offset + dvec2(q.uv));
    }
    return upper - lower;
}
}  // namespace

void add_compute_uv_aabb_size_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Model> const& models) {
        mistakes.push_back({id, Function::compute_uv_aabb_size, models});
    };
    add("footprint_of_the_object",
        {model([](FootprintQuestion const& q) { return box(corners(q, Plane::object, Miss::stays), 15); })});
    add("footprint_of_positions", {box_of_positions(0, 2), box_of_positions(0, 1), box_of_positions(1, 2)});
    add("footprint_of_neighbours", {model(from_the_first), model(from_one_to_the_next)});
    add("footprint_forgets_a_corner", {box_of(0b0111), box_of(0b1011), box_of(0b1101), box_of(0b1110), box_of(0b0011),
                                       box_of(0b0101), box_of(0b1001), box_of(0b0110), box_of(0b1010), box_of(0b1100)});
    add("footprint_seeded_with_zero", {model(around_zero)});
    add("footprint_misses_at_origin",
        {model([](FootprintQuestion const& q) { return box(corners(q, Plane::tangent, Miss::origin), 15); })});
    add("footprint_halved", {scaled(0.5), model(from_the_middle)});
    add("footprint_doubled", {scaled(2)});
}
}  // namespace testat
