#include "checks/footprint_size.h"

#include "checks/shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace testat {
namespace {
constexpr double pi = 3.14159265358979323846;

/// A point with the error that float may have made along every axis.
struct Place {
    glm::dvec3 position;
    double error;
    bool missed = false;  ///< the position is the intersection's own
    bool decided = true;
};

/// t is a quotient N / D. Both are sums of products of coordinates: N is off by 8 eps of the coordinates' lengths, D,
/// the cosine of the view, by 8 eps. So t is off by (dN + t dD) / (|D| - dD).
Place corner(FootprintQuestion const& q, int i)
{
    glm::dvec3 const origin = dvec3(q.origin[i]);
    glm::dvec3 const direction = glm::normalize(dvec3(q.direction[i]));
    glm::dvec3 const position = dvec3(q.position);
    glm::dvec3 const normal = dvec3(q.normal);
    double const lengths = glm::length(position) + glm::length(dvec3(q.shape.center));
    Place missed{position, 4 * eps * lengths, true};
    if (direction * normal == glm::dvec3(0))  // parallel in every arithmetic
        return missed;
    double const slope = glm::dot(direction, normal);
    double const height = glm::dot(position - origin, normal);
    double const t = height / slope;
    bool const level = (position - origin) * normal == glm::dvec3(0);
    bool const decided =
        std::abs(slope) > 8 * eps && (level || std::abs(height) > 8 * eps * (glm::length(origin) + lengths));
    missed.decided = decided;
    if (!(t > 0))
        return missed;
    double const error = 8 * eps * (glm::length(origin) + lengths + t) * (1 + 1 / (std::abs(slope) - 8 * eps));
    return {origin + t * direction, error, false, decided};
}

/// Where a corner may lie along u or v, relative to the intersection: one place, or two at a seam of the mapping.
struct Offset {
    double at[2];
    int count;
    double error;
};

bool is_float(double x)
{
    return double(static_cast<float>(x)) == x;
}

/// Whether float comes to the very uv of the intersection, so that a corner that misses has no offset at all: the
/// position lies from the centre along one axis of the mapping only, and all numbers are floats.
bool is_mapped_exactly(FootprintQuestion const& q, int axis)
{
    glm::dvec3 const d = dvec3(q.position) - dvec3(q.shape.center);
    glm::dvec3 const tangent = dvec3(q.shape.b);
    glm::dvec3 const along = axis == 0 ? tangent : glm::cross(tangent, dvec3(q.shape.a));
    int summands = 0;
    for (int i = 0; i < 3; ++i) {
        if (!is_float(d[i]) || !is_float(d[i] * along[i]))
            return false;
        summands += d[i] * along[i] != 0 ? 1 : 0;
    }
    return summands <= 1 && map_uv(q.shape, dvec3(q.position))[axis] == q.uv[axis];
}

/// Planes map linearly, so the error of the position goes along the mapping's axes.
Offset along_plane(FootprintQuestion const& q, Place const& place, int axis)
{
    double const uv = map_uv(q.shape, place.position)[axis];
    double change = 8 * eps * std::abs(uv);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 moved = place.position;
        moved[i] += place.error;
        change += std::abs(map_uv(q.shape, moved)[axis] - uv);
    }
    double const offset = uv - q.uv[axis];
    bool const exact = place.missed && is_mapped_exactly(q, axis);
    return {{offset, offset}, 1, exact ? 0 : change};
}

/// The angle under which an error is seen from a distance; beyond that, anything.
double seen_angle(double error, double distance)
{
    return error < distance ? std::asin(error / distance) : pi;
}

/// Longitude: a turn is cut at u = 0, where the corner may come to lie at either end.
Offset along_longitude(FootprintQuestion const& q, Place const& place)
{
    glm::dvec3 const d = place.position - dvec3(q.shape.center);
    double const scale = q.shape.scale_uv;
    double const u = map_uv(q.shape, place.position).x;
    double const error = scale * (seen_angle(std::sqrt(2.0) * place.error, std::hypot(d.x, d.z)) / (2 * pi) + 16 * eps);
    double const offset = u - q.uv[0];
    if (u - error < 0)
        return {{offset, offset + scale}, 2, error};
    return {{offset, offset - scale}, u + error > scale ? 2 : 1, error};
}

/// Latitude: near the poles, acos turns a rounding of its argument into the root of it.
Offset along_latitude(FootprintQuestion const& q, Place const& place)
{
    glm::dvec3 const d = place.position - dvec3(q.shape.center);
    double const sine = d.y / glm::length(d);
    double const angle = std::acos(sine);
    double const of_argument =
        std::max(std::acos(std::max(sine - 4 * eps, -1.0)) - angle, angle - std::acos(std::min(sine + 4 * eps, 1.0)));
    double const of_place = seen_angle(std::sqrt(3.0) * place.error, glm::length(d));
    double const offset = map_uv(q.shape, place.position).y - q.uv[1];
    return {{offset, 0}, 1, q.shape.scale_uv * ((of_argument + of_place) / pi + 16 * eps)};
}

Offset offset_of(FootprintQuestion const& q, Place const& place, int axis)
{
    if (q.shape.kind != ShapeKind::sphere)
        return along_plane(q, place, axis);
    return axis == 0 ? along_longitude(q, place) : along_latitude(q, place);
}

/// Two corners of a pair, along one axis.
struct Extent {
    double lower;
    double upper;
};

/// The framework's rule at a seam: where both offsets point the same way, the longer one is replaced by the mirrored
/// shorter one. Where an offset is no longer than its error, both is right.
void add_extents(double a, double a_error, double b, double b_error, std::vector<Extent>& extents)
{
    bool const unclear = std::abs(a) <= a_error || std::abs(b) <= b_error;
    bool const exactly_zero = (a == 0 && a_error == 0) || (b == 0 && b_error == 0);
    bool const same_way = a * b > 0;
    if (exactly_zero || unclear || !same_way)
        extents.push_back({std::min(a, b), std::max(a, b)});
    if (!exactly_zero && (unclear || same_way)) {
        double const shorter = std::min(std::abs(a), std::abs(b));
        extents.push_back({-shorter, shorter});
    }
}

std::vector<Extent> extents_of_pair(Offset const& a, Offset const& b)
{
    std::vector<Extent> extents;
    for (int i = 0; i < a.count; ++i)
        for (int j = 0; j < b.count; ++j)
            add_extents(a.at[i], a.error, b.at[j], b.error, extents);
    return extents;
}

/// Of all sizes that may come out, the one nearest to what was measured.
double nearest_size(std::vector<Extent> const& first, std::vector<Extent> const& second, double measured)
{
    double nearest = HUGE_VAL;
    for (auto const& a : first)
        for (auto const& b : second) {
            double const size = std::max(a.upper, b.upper) - std::min(a.lower, b.lower);
            if (!(std::abs(nearest - measured) <= std::abs(size - measured)))
                nearest = size;
        }
    return nearest;
}
}  // namespace

Footprint footprint(FootprintQuestion const& question, glm::dvec2 measured)
{
    Place const places[4] = {corner(question, 0), corner(question, 1), corner(question, 2), corner(question, 3)};
    Footprint result;
    for (int axis = 0; axis < 2; ++axis) {
        Offset offsets[4];
        for (int i = 0; i < 4; ++i)
            offsets[i] = offset_of(question, places[i], axis);
        result.size[axis] = nearest_size(extents_of_pair(offsets[0], offsets[1]),
                                         extents_of_pair(offsets[2], offsets[3]), measured[axis]);
        double error = 0;
        for (auto const& offset : offsets)
            error = std::max(error, offset.error);
        // The subtraction rounds once more, of numbers as large as uv.
        result.bound[axis] = 2 * error + eps * std::abs(question.uv[axis]);
    }
    result.decided = std::all_of(std::begin(places), std::end(places), [](Place const& p) { return p.decided; });
    if (!result.decided)
        result.bound = glm::dvec2(HUGE_VAL);
    return result;
}
}  // namespace testat
