#include "text.h"
#include "theory/expression.h"
#include "theory/matrices.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace testat::theory {
namespace {
using Json = nlohmann::ordered_json;
constexpr std::size_t most_factors = 16;

bool is_blank(std::string const& text)
{
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// Nothing but blank texts, whatever they stand in; rows in a matrix are as deep as it goes.
bool is_empty(Json const& answer, int depth = 0)
{
    if (answer.is_null() || (answer.is_string() && is_blank(answer.get_ref<std::string const&>())))
        return true;
    return answer.is_array() && depth < 2 &&
           std::all_of(answer.begin(), answer.end(), [&](Json const& part) { return is_empty(part, depth + 1); });
}

[[noreturn]] void refuse(std::string const& de, std::string const& en)
{
    throw Refused{{de, en}};
}

/// Says where it happened.
template <typename F>
auto within(Phrase const& place, F f) -> decltype(f())
{
    try {
        return f();
    } catch (Refused const& e) {
        refuse(place.de + ": " + e.why.de, place.en + ": " + e.why.en);
    }
}

double number(Json const& answer, Angles angles)
{
    double x = NAN;
    if (answer.is_number()) {
        x = answer.get<double>();
    } else if (answer.is_string() && !is_blank(answer.get_ref<std::string const&>())) {
        Value const value = Expression(answer.get_ref<std::string const&>(), angles).evaluate({});
        x = value.v[0];  // without variables there are no vectors
    } else {
        refuse("Hier fehlt eine Zahl oder ein Text wie \"cos(90°)\".",
               "A number or a text such as \"cos(90°)\" is missing.");
    }
    if (!std::isfinite(x))
        refuse("Das ergibt keine endliche Zahl.", "This is not a finite number.");
    return x;
}

Phrase entry_at(std::size_t row, std::size_t column)
{
    return {fmt::format("Zeile {}, Spalte {}", row + 1, column + 1),
            fmt::format("Row {}, column {}", row + 1, column + 1)};
}

glm::dmat4 matrix(Json const& answer, Angles angles)
{
    bool const is_square =
        answer.is_array() && answer.size() == 4 &&
        std::all_of(answer.begin(), answer.end(), [](Json const& row) { return row.is_array() && row.size() == 4; });
    if (!is_square)
        refuse("Eine homogene Matrix hat vier Zeilen mit je vier Zahlen: [[1, 0, 0, 0], ...].",
               "A homogeneous matrix has four rows of four numbers: [[1, 0, 0, 0], ...].");
    glm::dmat4 result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            result[int(column)][int(row)] =
                within(entry_at(row, column), [&] { return number(answer[row][column], angles); });
    return result;
}

glm::dvec3 triple(Json const& answer, Angles angles)
{
    if (!answer.is_array() || answer.size() != 3)
        refuse("Hier gehören drei Zahlen hin: [x, y, z].", "Three numbers belong here: [x, y, z].");
    return {number(answer[0], angles), number(answer[1], angles), number(answer[2], angles)};
}

glm::dvec3 axis(Json const& answer, Angles angles)
{
    constexpr char const* names[] = {"xu", "yv", "zw"};
    if (answer.is_string())
        for (int i = 0; i < 3; ++i)
            if (answer == std::string(1, names[i][0]) || answer == std::string(1, names[i][1]))
                return {i == 0, i == 1, i == 2};
    if (!answer.is_array())
        refuse("Eine Achse ist x, y oder z (auch u, v, w) oder ein Vektor [x, y, z].",
               "An axis is x, y or z (or u, v, w) or a vector [x, y, z].");
    glm::dvec3 const direction = triple(answer, angles);
    double const length = glm::length(direction);
    if (!(length > 0 && std::isfinite(length)))
        refuse("Eine Achse darf nicht der Nullvektor sein.", "An axis may not be the zero vector.");
    return direction / length;
}

void allow_only(Json const& object, std::initializer_list<char const*> keys)
{
    for (auto const& [key, value] : object.items())
        if (std::none_of(keys.begin(), keys.end(), [&, &name = key](char const* k) { return name == k; })) {
            std::string const shown = one_line(key, 40);
            refuse(fmt::format("„{}“ ist hier nicht vorgesehen; möglich: {}.", shown, fmt::join(keys, ", ")),
                   fmt::format("'{}' has no meaning here; there are: {}.", shown, fmt::join(keys, ", ")));
        }
}

/// Counter-clockwise as seen from the tip of the axis (Rodrigues).
glm::dmat4 rotation(Json const& answer, Angles angles)
{
    if (!answer.is_object() || !answer.contains("axis") || !answer.contains("degrees"))
        refuse("Eine Drehung braucht Achse und Winkel: {\"axis\": \"x\", \"degrees\": 90}.",
               "A rotation takes axis and angle: {\"axis\": \"x\", \"degrees\": 90}.");
    allow_only(answer, {"axis", "degrees"});
    glm::dvec3 const a = axis(answer.at("axis"), angles);
    double const angle = glm::radians(number(answer.at("degrees"), Angles::degrees));
    double const c = std::cos(angle), s = std::sin(angle);
    glm::dmat4 result(1.0);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit(0.0);
        unit[i] = 1;
        result[i] = glm::dvec4(c * unit + s * glm::cross(a, unit) + (1 - c) * a[i] * a, 0);
    }
    return result;
}

glm::dmat4 scaling(Json const& answer, Angles angles)
{
    glm::dvec3 const s = answer.is_array() ? triple(answer, angles) : glm::dvec3(number(answer, angles));
    return {{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}};
}

glm::dmat4 translation(Json const& answer, Angles angles)
{
    glm::dmat4 result(1.0);
    result[3] = glm::dvec4(triple(answer, angles), 1);
    return result;
}

glm::dmat4 inverse(glm::dmat4 const& matrix)
{
    if (!(std::abs(glm::determinant(matrix)) > 1e-12))
        refuse("Diese Matrix hat keine Inverse.", "This matrix has no inverse.");
    return glm::inverse(matrix);
}

glm::dmat4 named_factor(Json const& answer, Angles angles)
{
    constexpr std::pair<char const*, glm::dmat4 (*)(Json const&, Angles)> kinds[] = {
        {"translate", translation}, {"rotate", rotation}, {"scale", scaling}, {"matrix", matrix}};
    auto const is_given = [&](auto const& kind) { return answer.is_object() && answer.contains(kind.first); };
    if (std::count_if(std::begin(kinds), std::end(kinds), is_given) != 1)
        refuse("Ein Faktor ist genau eines von translate, rotate, scale und matrix.",
               "A factor is exactly one of translate, rotate, scale and matrix.");
    allow_only(answer, {"translate", "rotate", "scale", "matrix", "inverse", "meaning"});
    auto const kind = *std::find_if(std::begin(kinds), std::end(kinds), is_given);
    return kind.second(answer.at(kind.first), angles);
}

glm::dmat4 factor(Json const& answer, Angles angles)
{
    glm::dmat4 const result = named_factor(answer, angles);
    Json const inverted = answer.value("inverse", Json(false));
    if (!inverted.is_boolean())
        refuse("\"inverse\" ist true oder false.", "\"inverse\" is true or false.");
    return inverted.get<bool>() ? inverse(result) : result;
}

/// What is meant by angles without a degree sign is a guess, and no reason to refuse anything.
template <typename F>
Factor in_both_units(F read)
{
    Factor result{read(Angles::radians), {}};
    try {
        result.in_degrees = read(Angles::degrees);
    } catch (Refused const&) {
        result.in_degrees = result.matrix;
    }
    return result;
}
}  // namespace

std::optional<Factor> read_matrix(Json const& answer)
{
    if (is_empty(answer))
        return std::nullopt;
    return in_both_units([&](Angles angles) { return matrix(answer, angles); });
}

std::optional<std::vector<Factor>> read_factors(Json const& answer)
{
    if (is_empty(answer))
        return std::nullopt;
    if (!answer.is_array() || answer.size() > most_factors)
        refuse(fmt::format("Die Faktoren sind eine Liste von höchstens {} Matrizen.", most_factors),
               fmt::format("The factors are a list of at most {} matrices.", most_factors));
    std::vector<Factor> factors;
    for (std::size_t i = 0; i < answer.size(); ++i)
        factors.push_back(within({fmt::format("{}. Faktor", i + 1), fmt::format("Factor {}", i + 1)}, [&] {
            return in_both_units([&](Angles angles) { return factor(answer[i], angles); });
        }));
    return factors;
}
}  // namespace testat::theory
