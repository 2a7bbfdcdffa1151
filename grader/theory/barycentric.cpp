#include "theory/barycentric.h"

#include "theory/formula.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace testat::theory {
namespace {
using Json = nlohmann::ordered_json;
using Texts = std::array<std::string, 3>;

/// Null if there is no such member.
Json const* member(Json const* object, char const* key)
{
    if (object == nullptr || !object->is_object() || !object->contains(key))
        return nullptr;
    return &object->at(key);
}

/// What is no text and no number becomes one that no formula can be, and is refused as such.
std::string text_of(Json const* answer)
{
    if (answer == nullptr || answer->is_null())
        return "";
    if (answer->is_string())
        return answer->get<std::string>();
    return answer->is_number() ? answer->dump() : answer->is_array() ? "[...]" : "{...}";
}

Texts texts_of(Json const* section, std::array<char const*, 3> const& keys)
{
    return {text_of(member(section, keys[0])), text_of(member(section, keys[1])), text_of(member(section, keys[2]))};
}

std::vector<std::string> texture_formulas(Json const& answers)
{
    Json const* const answer = member(&answers, "P'");
    if (answer != nullptr && answer->is_object())
        return {text_of(member(answer, "u")), text_of(member(answer, "v"))};
    return {text_of(answer)};
}

using Areas = std::array<JudgedArea, 3>;

/// Three areas must be three triangles.
void refuse_doubles(Areas& areas)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j)
            if (areas[i].opposite && areas[i].opposite == areas[j].opposite) {
                areas[i].judgement.verdict = Verdict::wrong;
                areas[i].judgement.findings.push_back(
                    {"same_triangle",
                     {fmt::format("Das ist dasselbe Dreieck wie F{}: {}.", j + 1, part_names[*areas[i].opposite]),
                      fmt::format("This is the same triangle as F{}: {}.", j + 1, part_names[*areas[i].opposite])}});
                areas[i].opposite.reset();
            }
}

/// How well the areas could be named like this: 0 if one is known to be another part, else 1 for each right coordinate
/// more than none.
int fit(Areas const& areas, Texts const& coordinates, Opposite const& opposite)
{
    for (int i = 0; i < 3; ++i)
        if (areas[i].opposite && *areas[i].opposite != opposite[i])
            return 0;
    auto const judged = judge_coordinates(coordinates, opposite);
    return 1 + int(std::count_if(judged.begin(), judged.end(),
                                 [](Judgement const& j) { return j.verdict == Verdict::right; }));
}

Opposite best_names(Areas const& areas, Texts const& coordinates)
{
    Opposite order{0, 1, 2}, best = order;
    int most = 0;
    do
        if (int const points = fit(areas, coordinates, order); points > most) {
            most = points;
            best = order;
        }
    while (std::next_permutation(order.begin(), order.end()));
    return best;
}

/// What the reader has to compare with the figure.
Finding name_in_figure(int area, int opposite, bool answered)
{
    char const* const part = part_names[opposite];
    if (answered)
        return {"triangle",
                {fmt::format("Dreieck {}; so muss F{} auch in der Abbildung liegen.", part, area + 1),
                 fmt::format("Triangle {}; F{} must lie like that in the figure, too.", part, area + 1)}};
    return {"taken_as",
            {fmt::format("In den Koordinaten als Dreieck {} gelesen; vergleichen Sie mit der Abbildung.", part),
             fmt::format("Taken to be the triangle {} in the coordinates; compare with the figure.", part)}};
}

void tell_names(Areas& areas, Texts const& coordinates, Opposite const& opposite)
{
    bool const used = !std::all_of(coordinates.begin(), coordinates.end(), is_blank);
    for (int i = 0; i < 3; ++i) {
        Judgement& judgement = areas[i].judgement;
        bool const answered = judgement.verdict == Verdict::right;
        if (answered || (used && judgement.verdict == Verdict::unanswered))
            judgement.findings.push_back(name_in_figure(i, opposite[i], answered));
    }
}
}  // namespace

std::vector<Judgement> judge_barycentric(Json const& answers)
{
    Texts const formulas = texts_of(member(&answers, "areas"), {"F1", "F2", "F3"});
    Texts const coordinates = texts_of(member(&answers, "lambda"), {"A", "B", "C"});
    Areas areas{judge_area("F1", formulas[0]), judge_area("F2", formulas[1]), judge_area("F3", formulas[2])};
    refuse_doubles(areas);
    Opposite const opposite = best_names(areas, coordinates);
    tell_names(areas, coordinates, opposite);

    std::vector<Judgement> all;
    for (auto& area : areas)
        all.push_back(std::move(area.judgement));
    for (auto& coordinate : judge_coordinates(coordinates, opposite))
        all.push_back(std::move(coordinate));
    all.push_back(judge_texture_coordinates(texture_formulas(answers), opposite));
    return all;
}
}  // namespace testat::theory
