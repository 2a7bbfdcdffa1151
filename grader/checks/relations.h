#pragma once
#include "checks/check.h"

#include <array>
#include <type_traits>

/// Metamorphic checks: relations between a function's own answers, without an oracle. What they ask depends on the seed
/// and on the bytes of the upload, so that no table inside the file can know it.
namespace testat {
constexpr std::uint32_t relations_each = 128;

/// The stream of one check. It depends on the unknown textures, which depend on seed and upload, and on the name.
Random unknown_stream(Textures const& textures, std::string_view name);

/// Where each of `count` questions stands in its group: an order that no call can foresee.
std::vector<std::uint32_t> unknown_order(Textures const& textures, std::size_t count);

/// Wrong if no more than half of the answers at these places differ from each other: a constant fits many relations.
Deviation variety(Answers const& answers, std::vector<std::uint32_t> const& places);

/// What `ask` asks, and the same from the stream of an unknown texture.
std::function<Group(Random&, Textures const&)> twice(std::string const& name,
                                                     std::function<Group(Random&, Textures const&)> const& ask);

/// The worst of them; NaN is worse than all.
Deviation worst_of(std::initializer_list<Deviation> deviations);

/// Relations of one check, drawn from its stream: once to ask, and once more to judge.
template <typename Relation>
struct Relations {
    static constexpr std::size_t members = std::tuple_size_v<decltype(Relation::questions)>;
    std::vector<Relation> all;
    std::vector<std::uint32_t> order;

    std::array<std::uint32_t, members> places(std::size_t relation) const
    {
        std::array<std::uint32_t, members> found;
        for (std::size_t m = 0; m < members; ++m)
            found[m] = order[relation * members + m];
        return found;
    }
    std::vector<std::uint32_t> first_places() const
    {
        std::vector<std::uint32_t> found;
        for (std::size_t i = 0; i < all.size(); ++i)
            found.push_back(places(i)[0]);
        return found;
    }
};

template <typename Make>
auto draw_relations(std::string_view name, Textures const& textures, Make const& make)
{
    Random random = unknown_stream(textures, name);
    Relations<std::invoke_result_t<Make, Random&, Textures const&>> relations;
    for (std::uint32_t i = 0; i < relations_each; ++i)
        relations.all.push_back(make(random, textures));
    relations.order = unknown_order(textures, relations_each * relations.members);
    return relations;
}

template <typename Relation>
Group ask_relations(Kind kind, Relations<Relation> const& relations)
{
    std::vector<typename decltype(Relation::questions)::value_type> questions(relations.order.size());
    for (std::size_t i = 0; i < relations.all.size(); ++i)
        for (std::size_t m = 0; m < relations.members; ++m)
            questions[relations.places(i)[m]] = relations.all[i].questions[m];
    return make_group(kind, questions);
}

/// A metamorphic check. `make(random, textures)` gives a relation: a record with an array `questions` and with what
/// judging needs. `deviation(answers, relation, places)` judges it, with the places of its questions in the answers;
/// a mismatch is told with its last question. `varied` looks at the places of all first questions.
template <typename Make, typename DeviationOf>
UnitCheck metamorphic_check(std::string const& name, Function function, Kind kind, Make const& make,
                            DeviationOf const& deviation, decltype(&variety) varied = variety)
{
    auto const ask = [=](Random&, Textures const& textures) {
        return ask_relations(kind, draw_relations(name, textures, make));
    };
    auto const judge = [=](Answers const& answers, Textures const& textures) {
        auto const relations = draw_relations(name, textures, make);
        Verdict verdict;
        for (std::size_t i = 0; i < relations.all.size(); ++i)
            verdict.offer(relations.places(i).back(), deviation(answers, relations.all[i], relations.places(i)));
        if (verdict.passed())
            verdict.offer(relations.order[0], varied(answers, relations.first_places()));
        return verdict;
    };
    return {name, function, ask, judge, true};
}
}  // namespace testat
